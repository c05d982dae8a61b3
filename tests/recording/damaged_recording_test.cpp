#include <archive.h>
#include <archive_entry.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "recorded_scenes.h"
#include "sim/core/error.h"
#include "sim/recording/replay.h"
#include "tests/files/test_folder.h"

namespace griffith {
namespace {

using ::testing::HasSubstr;
using namespace griffith::testing;

Recording small_recording() { return record(played(struck_wall(), 6)); }

/// Returns the problem of an archive of these files; empty if there is none.
std::string problem_of(const FileTree& files) {
  const auto file = written(empty_folder() / "run.tar.zst", pack_files(files, "run"));
  try {
    read_recording(file);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

/// Returns the problem with one file changed.
std::string problem_with(const std::string& name, const std::string& content) {
  FileTree files = files_of(small_recording());
  EXPECT_TRUE(files.contains(name));
  files[name] = content;
  return problem_of(files);
}

std::string with_text(std::string text, const std::string& old_part, const std::string& new_part) {
  const auto at = text.find(old_part);
  EXPECT_NE(at, std::string::npos) << old_part;
  return text.replace(at, old_part.size(), new_part);
}

/// Returns an archive of one entry that is not a file.
std::string archive_with(const std::string& name, unsigned type, const std::string& target) {
  std::string bytes(1 << 16, '\0');
  std::size_t used = 0;
  archive* writer = archive_write_new();
  archive_write_set_format_pax_restricted(writer);
  archive_write_open_memory(writer, bytes.data(), bytes.size(), &used);
  archive_entry* entry = archive_entry_new();
  archive_entry_set_pathname(entry, name.c_str());
  archive_entry_set_filetype(entry, type);
  if (type == AE_IFLNK) archive_entry_set_symlink(entry, target.c_str());
  if (type == AE_IFREG && !target.empty()) archive_entry_set_hardlink(entry, target.c_str());
  archive_write_header(writer, entry);
  archive_entry_free(entry);
  archive_write_close(writer);
  archive_write_free(writer);
  return bytes.substr(0, used);
}

TEST(DamagedRecording, AWholeOneHasNoProblem) { EXPECT_EQ(problem_of(files_of(small_recording())), ""); }

TEST(DamagedRecording, PathsThatLeadElsewhereAreRefused) {
  for (const char* path : {"../evil", "/tmp/evil", "a/../../evil", ".."})
    EXPECT_THROW(unpack_files(pack_files({{path, "x"}}, "run"), "run"), InputError) << path;
  EXPECT_EQ(unpack_files(pack_files({{"./a/b", "x"}}, "run"), "run"), (FileTree{{"a/b", "x"}})) << "as tar writes it";
}

TEST(DamagedRecording, LinksAndDevicesAreRefused) {
  EXPECT_THROW(unpack_files(archive_with("a", AE_IFLNK, "/etc/passwd"), "run"), InputError);
  EXPECT_THROW(unpack_files(archive_with("a", AE_IFREG, "/etc/passwd"), "run"), InputError) << "a hard link";
  EXPECT_THROW(unpack_files(archive_with("a", AE_IFIFO, ""), "run"), InputError);
  EXPECT_TRUE(unpack_files(archive_with("a", AE_IFDIR, ""), "run").empty());
}

TEST(DamagedRecording, AMissingFileIsNamed) {
  for (const char* name : {"scene.json", "inputs.json", "hashes.csv", "versions.json"}) {
    FileTree files = files_of(small_recording());
    files.erase(name);
    EXPECT_THAT(problem_of(files), HasSubstr(name));
  }
}

TEST(DamagedRecording, HashesHaveTheirPlaceInErrors) {
  const std::string good = files_of(small_recording()).at("hashes.csv");
  EXPECT_THAT(problem_with("hashes.csv", with_text(good, "\n3,", "\n4,")), HasSubstr("hashes.csv:5: "));
  EXPECT_THAT(problem_with("hashes.csv", with_text(good, "\n3,", "\n3,x")), HasSubstr("hashes.csv:5: "));
  EXPECT_THAT(problem_with("hashes.csv", with_text(good, ",energy", ",money")), HasSubstr("version that made it"));
  EXPECT_THAT(problem_with("hashes.csv", good.substr(0, good.size() - 20)), HasSubstr("hashes.csv:8: "));
  EXPECT_THAT(problem_with("hashes.csv", ""), HasSubstr("hashes.csv"));
}

TEST(DamagedRecording, InputsThatCannotBeDoneAreRefused) {
  const std::string good = files_of(small_recording()).at("inputs.json");
  EXPECT_THAT(problem_with("inputs.json", with_text(good, "\"step\": 4", "\"step\": 7")), HasSubstr("step 7"));
  EXPECT_THAT(problem_with("inputs.json", with_text(good, "\"step\": 4", "\"step\": -1")), HasSubstr("/inputs/0/step"));
  EXPECT_THAT(problem_with("inputs.json", with_text(good, "\"fire\"", "\"sing\"")), HasSubstr("sing"));
  EXPECT_THAT(problem_with("inputs.json", "{"), HasSubstr("inputs.json:1"));
  const std::string material = "{\"step\": 1, \"set_material\": {\"scene_body\": 3, \"material\": \"granite\"}}";
  EXPECT_THAT(problem_with("inputs.json", "{\"version\": 1, \"inputs\": [" + material + "]}"), HasSubstr("body 3"));
  const std::string shot = "{\"step\": 1, \"fire\": {\"shape\": {\"surface\": {\"path\": \"/etc/passwd\"}}}}";
  EXPECT_THAT(problem_with("inputs.json", "{\"version\": 1, \"inputs\": [" + shot + "]}"), HasSubstr("surface"));
}

TEST(DamagedRecording, FilesOfThisMachineAreNotReadForIt) {
  const auto folder = empty_folder();
  FileTree files = files_of(begin_recording(World(recorded_scenes(folder)[3].scene)));
  const std::string scene = files.at("scene.json");
  EXPECT_EQ(problem_of(files), "");
  for (const char* path : {"/etc/passwd", "assets/1/../../x.msh", "assets/2/wall.node", "scene.json"}) {
    files["scene.json"] = with_text(scene, "assets/1/wall.node", path);
    EXPECT_THAT(problem_of(files), HasSubstr("does not hold")) << path;
  }
}

TEST(DamagedRecording, NoNameIsBothAFileAndAFolder) {
  for (const FileTree& files :
       {FileTree{{"x", "1"}, {"x/y", "2"}}, FileTree{{"a/x", "1"}, {"a/x-", ""}, {"a/x/y/z", "2"}}})
    EXPECT_THROW(unpack_files(pack_files(files, "run"), "run"), InputError);
}

TEST(DamagedRecording, NamesThatNoFolderCanHoldOrNoTerminalShowAreRefused) {
  for (const std::string& name :
       {std::string(256, 'x'), "a/" + std::string(300, 'x'), std::string("a\x1b[2J"), std::string("a\nb")})
    EXPECT_THROW(unpack_files(pack_files({{name, "x"}}, "run"), "run"), InputError) << name;
  EXPECT_NO_THROW(unpack_files(pack_files({{std::string(255, 'x'), "x"}}, "run"), "run"));
}

TEST(DamagedRecording, ASmallArchiveDoesNotUnpackToALargeOne) {
  const std::string zeros = pack_files({{"assets/1/zeros", std::string(200 << 20, '\0')}}, "run");
  ASSERT_LT(zeros.size(), 100'000u);
  EXPECT_THROW(unpack_files(zeros, "run"), InputError);
}

/// Returns `count` times "{}".
std::string empty_objects(int count) {
  std::string list = "[{}";
  for (int i = 1; i < count; ++i) list += ",{}";
  return list + "]";
}

TEST(DamagedRecording, ListsOfNothingAreRefusedWhileTheyAreRead) {
  FileTree files = files_of(small_recording());
  files["inputs.json"] = empty_objects(15'000'000);
  EXPECT_THAT(problem_of(files), HasSubstr("more values than"));
  files["inputs.json"] = "{\"version\": 1, \"inputs\": " + empty_objects(300'000) + "}";
  EXPECT_THAT(problem_of(files), HasSubstr("more than 250,000 items"));
  files["inputs.json"] = "{\"version\": 1, \"inputs\": " + empty_objects(200'000) + "}";
  EXPECT_THAT(problem_of(files), HasSubstr("/inputs/0"));
}

TEST(DamagedRecording, WhatCannotBeWrittenWholeLeavesNothing) {
  const auto folder = empty_folder();
  EXPECT_THROW(write_files({{"a/b/c", "1"}, {"a/b/c/d", "2"}}, folder / "new/run"), InputError);
  EXPECT_FALSE(std::filesystem::exists(folder / "new"));
  written(folder / "there", "mine");
  EXPECT_THROW(write_files({{"a", "1"}, {"there/b", "2"}}, folder), InputError);
  EXPECT_EQ(text_of(folder / "there"), "mine");
  EXPECT_EQ(files_in(folder), 1);
}

TEST(DamagedRecording, AnythingElseIsNoRecording) {
  const auto folder = empty_folder();
  for (const std::string& content : {std::string(), std::string("{}"), std::string(5000, 'x'), std::string(5000, '\0')})
    EXPECT_THROW(read_recording(written(folder / "file", content)), InputError) << content.substr(0, 5);
  EXPECT_THROW(read_recording(folder), InputError);
  EXPECT_THROW(read_recording(folder / "none"), InputError);
  const std::string whole = pack_files(files_of(small_recording()), "run");
  for (std::size_t size = 0; size < whole.size(); size += 97)
    EXPECT_THROW(read_recording(written(folder / "cut", whole.substr(0, size))), InputError) << size;
}

/// Any damaged recording is rejected or replays to its end.
TEST(DamagedRecording, RandomDamageDoesNoHarm) {
  const auto folder = empty_folder();
  const FileTree whole = files_of(record(played(recorded_scenes(folder)[3].scene, 3)));
  std::mt19937 random(5);
  const auto below = [&](std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
  };
  const std::string likely = "0123456789abcdef.,-";
  int refused = 0, different = 0;
  for (int i = 0; i < 120; ++i) {
    FileTree files = whole;
    std::string& content = std::next(files.begin(), static_cast<std::ptrdiff_t>(below(files.size())))->second;
    const bool wildly = i % 4 == 0;
    content[below(content.size())] = wildly ? static_cast<char>(below(256)) : likely[below(likely.size())];
    std::string bytes = pack_files(files, "run");
    if (wildly) bytes[below(bytes.size())] ^= static_cast<char>(1 + below(255));
    try {
      const Recording recording = read_recording(written(folder / "damaged", bytes));
      Replay replay(recording);
      while (!replay.at_end()) replay.advance();
      different += replay.difference().has_value();
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 20);
  EXPECT_GT(different, 3);
}

}  // namespace
}  // namespace griffith
