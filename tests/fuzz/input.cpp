#include "tests/fuzz/input.h"

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace griffith::fuzz {
namespace {

namespace fs = std::filesystem;

void add_folder(const fs::path& folder, const std::string& prefix, Input& input) {
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      input.files[prefix + entry.path().lexically_relative(folder).generic_string()] = read_file(entry.path());
}

/// Returns the entry of a folder; the points name a TetGen pair.
std::string entry_in(const fs::path& folder) {
  std::string found;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.path().stem() == "input" && name > found) found = name;
  }
  return found;
}

Input read_single_file(const fs::path& path) {
  Input input{"input" + path.extension().string(), {}};
  for (const auto& entry : fs::directory_iterator(fs::absolute(path).parent_path())) {
    const std::string ending = entry.path().extension().string();
    const bool pair = entry.path().stem() == path.stem() && (ending == ".node" || ending == ".ele");
    if (pair) input.files["input" + ending] = read_file(entry.path());
  }
  input.files[input.entry] = read_file(path);
  return input;
}

}  // namespace

std::string read_file(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw std::runtime_error(path.string() + ": cannot be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

void write_input(const Input& input, const fs::path& folder) {
  fs::remove_all(folder);
  fs::create_directories(folder);
  for (const auto& [name, content] : input.files) {
    fs::create_directories((folder / name).parent_path());
    std::ofstream(folder / name, std::ios::binary) << content;
  }
}

Input read_input(const fs::path& path) {
  if (!fs::is_directory(path)) return read_single_file(path);
  Input input{entry_in(path), {}};
  const bool csv = input.entry.empty();
  if (csv) input.entry = "input";
  add_folder(path, csv ? "input/" : "", input);
  return input;
}

std::size_t size_of(const Input& input) {
  std::size_t size = 0;
  for (const auto& [name, content] : input.files) size += content.size();
  return size;
}

}  // namespace griffith::fuzz
