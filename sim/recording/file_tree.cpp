#include "sim/recording/file_tree.h"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <memory>
#include <ranges>
#include <system_error>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/replace_file.h"

namespace griffith {
namespace {

namespace fs = std::filesystem;

constexpr char kOtherFile[] = "is it the intended file?";

using Reader = std::unique_ptr<archive, decltype(&archive_read_free)>;
using Writer = std::unique_ptr<archive, decltype(&archive_write_free)>;
using Entry = std::unique_ptr<archive_entry, decltype(&archive_entry_free)>;

[[noreturn]] void fail(archive* archive, const std::string& where) {
  const char* reason = archive_error_string(archive);
  throw InputError(where, std::string("is not a complete recording: ") + (reason ? reason : "damaged"), kOtherFile);
}

void check(int result, archive* archive, const std::string& where) {
  if (result < ARCHIVE_WARN) fail(archive, where);
}

/// True if any file system can store the name and any terminal show it.
bool is_plain_name(const fs::path& part) {
  constexpr std::size_t kLongestName = 255;
  const std::string name = part.string();
  const auto is_control = [](unsigned char c) { return c < ' ' || c == 0x7F; };
  return name.size() <= kLongestName && std::ranges::none_of(name, is_control);
}

/// True if a path, without "." in it, stays below its starting folder and has permitted names.
bool stays_below(const std::string& path) {
  constexpr std::size_t kLongest = 1000;
  const fs::path plain(path);
  const auto leads_up = [](const fs::path& part) { return part == ".." || part == "." || part.empty(); };
  return !path.empty() && path.size() < kLongest && plain.is_relative() && std::ranges::none_of(plain, leads_up) &&
         std::ranges::all_of(plain, is_plain_name);
}

/// Throws if a file would also be a folder.
void require_tree(const FileTree& files, const std::string& where) {
  for (const auto& [path, content] : files)
    for (fs::path above = fs::path(path).parent_path(); !above.empty(); above = above.parent_path())
      if (files.contains(above.generic_string()))
        throw InputError(where, "holds \"" + above.generic_string() + "\" both as a file and as a folder", kOtherFile);
}

/// Returns the largest unpacked size of an archive [bytes]. Files of runs shrink some ten times, at most a hundred.
std::int64_t most_unpacked(std::size_t packed) {
  constexpr std::int64_t kAlways = 64 << 20, kMostTimes = 1000;
  return std::clamp(kMostTimes * static_cast<std::int64_t>(packed), kAlways, kMaxTreeBytes);
}

void add_file(archive* writer, const std::string& path, const std::string& content, const std::string& where) {
  const Entry entry(archive_entry_new(), archive_entry_free);
  archive_entry_set_pathname(entry.get(), path.c_str());
  archive_entry_set_size(entry.get(), static_cast<la_int64_t>(content.size()));
  archive_entry_set_filetype(entry.get(), AE_IFREG);
  archive_entry_set_perm(entry.get(), 0644);
  check(archive_write_header(writer, entry.get()), writer, where);
  if (archive_write_data(writer, content.data(), content.size()) < 0) fail(writer, where);
}

la_ssize_t append_bytes(archive*, void* text, const void* bytes, std::size_t size) {
  static_cast<std::string*>(text)->append(static_cast<const char*>(bytes), size);
  return static_cast<la_ssize_t>(size);
}

/// Returns the remaining content of the entry. `allowed` [bytes].
std::string content_of_entry(archive* reader, std::int64_t allowed, const std::string& where) {
  std::string content;
  const void* block = nullptr;
  std::size_t size = 0;
  la_int64_t offset = 0;
  for (int result; (result = archive_read_data_block(reader, &block, &size, &offset)) != ARCHIVE_EOF;) {
    check(result, reader, where);
    if (offset != std::ssize(content)) throw InputError(where, "holds a file with gaps", kOtherFile);
    if (std::ssize(content) + static_cast<std::int64_t>(size) > allowed)
      throw InputError(where, "unpacks to more than a file of its size can hold, or to more than a gigabyte",
                       kOtherFile);
    content.append(static_cast<const char*>(block), size);
  }
  return content;
}

/// Returns the path of a file in the archive. Throws for other entries.
std::string path_of_entry(archive_entry* entry, const std::string& where) {
  const char* name = archive_entry_pathname(entry);
  const std::string path = name ? fs::path(name).lexically_normal().generic_string() : "";  // tar writes "./x"
  if (!stays_below(path))
    throw InputError(where, "holds a file of the name \"" + path + "\"", "paths in a recording lead nowhere else");
  if (archive_entry_filetype(entry) != AE_IFREG || archive_entry_hardlink(entry) || archive_entry_symlink(entry))
    throw InputError(where, "holds \"" + path + "\", which is not a regular file", kOtherFile);
  return path;
}

/// Creates a folder and its missing parents; appends the new ones to `made`.
void make_folder(const fs::path& folder, std::vector<fs::path>& made) {
  std::error_code error;
  if (folder.empty() || fs::is_directory(folder, error)) return;
  make_folder(folder.parent_path(), made);
  if (fs::create_directory(folder, error)) return made.push_back(folder);
  throw InputError(folder.string(), "cannot be created as a folder: " + error.message(),
                   "name a folder that may be written to");
}

}  // namespace

std::string pack_files(const FileTree& files, const std::string& where) {
  std::int64_t bytes = 0;
  for (const auto& [path, content] : files) bytes += std::ssize(content);
  if (bytes > kMaxTreeBytes) throw InputError(where, "would hold more than a gigabyte", "record a smaller scene");
  std::string packed;
  const Writer writer(archive_write_new(), archive_write_free);
  check(archive_write_set_format_pax_restricted(writer.get()), writer.get(), where);
  check(archive_write_add_filter_zstd(writer.get()), writer.get(), where);
  archive_write_set_bytes_in_last_block(writer.get(), 1);  // no padding after the compressed stream
  check(archive_write_open(writer.get(), &packed, nullptr, append_bytes, nullptr), writer.get(), where);
  for (const auto& [path, content] : files) add_file(writer.get(), path, content, where);
  check(archive_write_close(writer.get()), writer.get(), where);
  return packed;
}

FileTree unpack_files(const std::string& archive, const std::string& where) {
  constexpr std::size_t kMaxFiles = 100'000;
  const Reader reader(archive_read_new(), archive_read_free);
  check(archive_read_support_format_tar(reader.get()), reader.get(), where);
  check(archive_read_support_filter_zstd(reader.get()), reader.get(), where);
  check(archive_read_open_memory(reader.get(), archive.data(), archive.size()), reader.get(), where);
  FileTree files;
  std::int64_t left = most_unpacked(archive.size());
  std::size_t entries = 0;
  archive_entry* entry = nullptr;
  for (int result; (result = archive_read_next_header(reader.get(), &entry)) != ARCHIVE_EOF;) {
    check(result, reader.get(), where);
    if (++entries > kMaxFiles) throw InputError(where, "holds too many files", kOtherFile);
    if (archive_entry_filetype(entry) == AE_IFDIR) continue;
    const std::string path = path_of_entry(entry, where);
    std::string content = content_of_entry(reader.get(), left, where);
    left -= std::ssize(content);
    if (!files.emplace(path, std::move(content)).second)
      throw InputError(where, "holds \"" + path + "\" twice", kOtherFile);
  }
  require_tree(files, where);
  return files;
}

void write_files(const FileTree& files, const fs::path& folder) {
  std::vector<fs::path> made;
  try {
    for (const auto& [path, content] : files) {
      make_folder((folder / path).parent_path(), made);
      replace_file(folder / path, content);
      made.push_back(folder / path);
    }
  } catch (const InputError&) {
    std::error_code ignored;
    for (const fs::path& path : std::views::reverse(made)) fs::remove(path, ignored);
    throw;
  }
}

}  // namespace griffith
