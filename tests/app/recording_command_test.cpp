#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "app/output/output.h"
#include "program.h"
#include "sim/recording/recording.h"

namespace griffith::app {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string quoted(const std::filesystem::path& path) { return "\"" + path.string() + "\""; }

/// The recording of some steps of the small wall.
std::filesystem::path recorded_wall(int frames = 12, const std::string& options = "") {
  const std::filesystem::path file = test_folder() / "wall.tar.zst";
  const Outcome outcome = run_program("simulate " + quoted(small_wall_file()) + " --frames " + std::to_string(frames) +
                                      options + " --record " + quoted(file));
  EXPECT_EQ(outcome.code, 0) << outcome.output;
  return file;
}

/// The recording with one hash changed, as if the run had gone otherwise.
std::filesystem::path altered(const std::filesystem::path& file, std::size_t step, std::size_t field) {
  Recording recording = read_recording(file);
  recording.hashes[step][field] ^= 1;
  recording.versions[1].second = "Debug";
  const std::filesystem::path other = test_folder() / "altered.tar.zst";
  write_recording(recording, other);
  return other;
}

TEST(RecordingCommand, AReplayIsEqualWithAnyNumberOfThreads) {
  const auto file = recorded_wall();
  for (const char* threads : {"", " --threads 1", " --threads 2", " --threads 4"}) {
    const Outcome outcome = run_program("replay " + quoted(file) + threads);
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_EQ(outcome.output, "12 steps equal\n") << threads;
  }
}

TEST(RecordingCommand, AReplayThatDiffersNamesStepFieldAndVersions) {
  const Outcome outcome = run_program("replay " + quoted(altered(recorded_wall(), 7, 3)));
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("step 7 differs first (of 12 steps), in: stresses"));
  EXPECT_THAT(outcome.output, HasSubstr("Debug"));
  EXPECT_THAT(outcome.output, Not(HasSubstr("compiler"))) << "it is the same";
}

TEST(RecordingCommand, ARecordingUnpacksToAScene) {
  const auto folder = test_folder() / "unpacked";
  std::filesystem::remove_all(folder);
  const Outcome outcome = run_program("replay " + quoted(recorded_wall()) + " --extract " + quoted(folder));
  EXPECT_EQ(outcome.code, 0) << outcome.output;
  EXPECT_EQ(run_program("check " + quoted(folder / "scene.json")).code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "hashes.csv"));
  const Outcome again = run_program("replay " + quoted(recorded_wall()) + " --extract " + quoted(folder));
  EXPECT_EQ(again.code, 2);
  EXPECT_THAT(again.output, HasSubstr("is not empty"));
}

TEST(RecordingCommand, ABugReportOfASceneReplays) {
  const auto file = test_folder() / "report.tar.zst";
  const Outcome bundle = run_program("bundle " + quoted(small_wall_file()) + " --frames 10 -o " + quoted(file));
  EXPECT_EQ(bundle.code, 0) << bundle.output;
  EXPECT_EQ(run_program("replay " + quoted(file)).output, "10 steps equal\n");
  const Recording report = read_recording(file);
  EXPECT_THAT(report.extras.at("README.txt"), HasSubstr("griffith replay FILE"));
  EXPECT_THAT(report.extras.at("log.txt"), HasSubstr("10 steps of "));
  EXPECT_TRUE(report.extras.at("screenshot.png").starts_with("\x89PNG"));
  EXPECT_FALSE(version_of(report.versions, "graphics").empty());
}

TEST(RecordingCommand, ABugReportOfARecordingKeepsItsHashesAndLog) {
  const auto recording = altered(recorded_wall(), 4, 0), first = test_folder() / "first.tar.zst",
             second = test_folder() / "second.tar.zst";
  EXPECT_EQ(run_program("bundle " + quoted(recording) + " -o " + quoted(first)).code, 0);
  EXPECT_EQ(run_program("bundle " + quoted(first) + " -o " + quoted(second)).code, 0);
  const Recording report = read_recording(second);
  EXPECT_EQ(report.hashes, read_recording(recording).hashes);
  EXPECT_EQ(report.versions, read_recording(recording).versions);
  const std::string log = report.extras.at("log.txt");
  EXPECT_THAT(log, HasSubstr("step 4 differs first"));
  EXPECT_NE(log.find("bundle altered.tar.zst"), std::string::npos);
  EXPECT_NE(log.find("bundle first"), std::string::npos) << "what was said before is kept";
}

TEST(RecordingCommand, WithoutGraphicsABugReportSaysSo) {
  const auto file = test_folder() / "report.tar.zst";
  const Outcome outcome = run_program("bundle " + quoted(small_wall_file()) + " --frames 2 -o " + quoted(file),
                                      "env __EGL_VENDOR_LIBRARY_DIRS=/nowhere __EGL_VENDOR_LIBRARY_FILENAMES=/nowhere");
  EXPECT_EQ(outcome.code, 0) << outcome.output;
  const Recording report = read_recording(file);
  EXPECT_FALSE(report.extras.contains("screenshot.png"));
  EXPECT_THAT(report.extras.at("log.txt"), HasSubstr("no picture: "));
}

TEST(RecordingCommand, WrongUsageAndFilesAreReported) {
  const std::string scene = quoted(small_wall_file());
  EXPECT_EQ(run_program("replay").code, 2);
  EXPECT_EQ(run_program("replay " + quoted(test_folder() / "none")).code, 2);
  const Outcome of_scene = run_program("replay " + scene);
  EXPECT_EQ(of_scene.code, 2);
  EXPECT_THAT(of_scene.output, HasSubstr("is not a complete recording"));
  const Outcome unwritable = run_program("simulate " + scene + " --frames 1000000 --record /nowhere/run.tar.zst");
  EXPECT_EQ(unwritable.code, 2) << "reported before the run";
  EXPECT_EQ(run_program("bundle " + scene + " -o /nowhere/run.tar.zst").code, 2);
  EXPECT_THAT(run_program("bundle " + scene + " -o run.zip").output, HasSubstr("use the extension .tar.zst"));
  const Outcome frames =
      run_program("bundle " + quoted(recorded_wall(2)) + " --frames 3 -o " + quoted(test_folder() / "x"));
  EXPECT_EQ(frames.code, 2);
  EXPECT_THAT(frames.output, HasSubstr("--frames"));
}

TEST(RecordingCommand, AReplayThatIsInterruptedLeavesNothing) {
  // Where nothing falls, nothing sleeps: sleepers' steps would be made in no time.
  Recording recording = read_recording(recorded_wall(2, " --set 'gravity=[0,0,0]'"));
  recording.hashes.resize(500'000);
  const auto file = test_folder() / "long.tar.zst", temporary = test_folder() / "temporary";
  const auto report = test_folder() / "report.tar.zst";
  write_recording(recording, file);
  std::filesystem::create_directories(temporary);
  std::filesystem::remove(report);
  const Outcome outcome = run_program("bundle " + quoted(file) + " -o " + quoted(report),
                                      "env TMPDIR=" + quoted(temporary) + " timeout --preserve-status -s INT 3");
  EXPECT_EQ(outcome.code, 130) << outcome.output;
  EXPECT_TRUE(std::filesystem::is_empty(temporary));
  EXPECT_FALSE(std::filesystem::exists(report));
}

TEST(RecordingCommand, FilesFromOutsideTheScenesFolderArePackedOnlyWhenAskedFor) {
  const auto folder = test_folder() / "scene";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  test_file("tet.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  const auto scene = test_file("scene/scene.json", R"({"version": 1, "bodies": [{"shape": {"surface":
      {"path": "../tet.off", "method": "volumetric", "element_size": 0.2}}}]})");
  const std::string file = quoted(folder / "run.tar.zst");
  EXPECT_EQ(run_program("simulate " + quoted(scene) + " --frames 1").code, 0) << "what the user opens is read";
  for (const std::string& command : {"simulate " + quoted(scene) + " --frames 1 --record " + file,
                                     "bundle " + quoted(scene) + " --frames 1 -o " + file}) {
    const Outcome refused = run_program(command);
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.output, HasSubstr("outside the scene's folder"));
    EXPECT_FALSE(std::filesystem::exists(folder / "run.tar.zst"));
    EXPECT_EQ(run_program(command + " --pack-outside").code, 0);
    EXPECT_TRUE(std::filesystem::remove(folder / "run.tar.zst"));
  }
}

TEST(RecordingCommand, UnpackingThatFailsLeavesNothing) {
  Recording recording = read_recording(recorded_wall(2));
  recording.extras["x"] = "a file";
  recording.extras["x/y"] = "and a folder";
  const auto file = test_folder() / "odd.tar.zst", folder = test_folder() / "unpacked";
  std::filesystem::remove_all(folder);
  write_recording(recording, file);
  const Outcome outcome = run_program("replay " + quoted(file) + " --extract " + quoted(folder));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.output, HasSubstr("both as a file and as a folder"));
  EXPECT_FALSE(std::filesystem::exists(folder));
}

TEST(Printing, NothingFromAFileReachesTheTerminalAsItIs) {
  EXPECT_EQ(printable("a\x1b[2Jb\x7f\n"), "a\\x1b[2Jb\\x7f\\x0a");
  EXPECT_EQ(printable("Mauerwerk ä€😀"), "Mauerwerk ä€😀");
  EXPECT_EQ(printable("\xff\xc2\x9b\xe2\x80\xae"), "\\xff\\xc2\\x9b\\xe2\\x80\\xae") << "no UTF-8, C1, right to left";
  const auto scene =
      test_file("odd.json", R"({"version": 1, "bodies": [{"name": "a\u001b]0;b\u0007\nc", "shape": {"box": {}}},
      {"name": "a\u001b]0;b\u0007\nc", "shape": {"box": {}}, "no\u001b[31m": 1}], "gr\u001b[2Javity": 1})");
  const auto script = test_file("odd.script", "click \x1b[2Jnothing\nlo\x1b[31mok\n");
  for (const std::string& command :
       {"check " + quoted(scene), "simulate --frames 1 " + quoted(scene), "script " + quoted(script),
        "simulate --frames 1 " + quoted("/tmp/\x1b[2J"), quoted("\x1b[2J")}) {
    const Outcome outcome = run_program(command);
    EXPECT_EQ(outcome.code, 2) << command;
    EXPECT_EQ(outcome.output.find('\x1b'), std::string::npos) << command;
    EXPECT_EQ(outcome.output.find('\a'), std::string::npos) << command;
  }
}

TEST(RecordingCommand, ADiskThatIsFullLeavesNoHalfRecording) {
  const Outcome outcome = run_program("simulate " + quoted(small_wall_file()) + " --frames 3 --record /dev/full");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.output, HasSubstr("/dev/full"));
}

}  // namespace
}  // namespace griffith::app
