#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>

#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "app/study/run_record.h"
#include "program.h"
#include "sim/core/descriptor.h"
#include "sim/core/number_text.h"
#include "sim/core/read_file.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;

/// A folder of the test's own that is not there yet.
fs::path fresh_folder(const std::string& name) {
  const fs::path folder = test_folder() / name;
  fs::remove_all(folder);
  return folder;
}

std::string sweep_of(const fs::path& scene, const fs::path& folder, const std::string& more) {
  return "sweep " + scene.string() + " -o " + folder.string() + " " + more;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string csv_in(const fs::path& folder) { return read_file(folder / "outcomes.csv"); }

TEST(SetOption, IsCheckedAsTheFileIs) {
  const fs::path scene = small_wall_file();
  EXPECT_EQ(run_program("check " + scene.string() + " --set projectiles/0/speed=3").code, 0);
  for (const char* command : {"check ", "simulate --frames 0 "}) {
    const Outcome refused = run_program(command + scene.string() + " --set projectiles/0/speed=-3");
    EXPECT_EQ(refused.code, 2);
    EXPECT_NE(refused.output.find("#/projectiles/0/speed: is -3"), std::string::npos) << refused.output;
  }
}

TEST(SetOption, BeforeACommandOrWithoutASceneIsRefused) {
  const std::string scene = small_wall_file().string();
  for (const std::string& arguments :
       {"--set projectiles/0/speed=3 simulate " + scene + " --frames 0", std::string("--set projectiles/0/speed=3"),
        "--threads 1 simulate " + scene + " --frames 0"}) {
    const Outcome refused = run_program(arguments);
    EXPECT_EQ(refused.code, 2) << arguments << refused.output;
  }
}

TEST(SweepCommand, PicturesOfAnotherStepAreOthers) {
  const fs::path folder = test_folder() / "out";
  fs::remove_all(folder);
  const std::string command = "sweep " + small_wall_file().string() + " --frames 9 --vary projectiles/0/speed=30 -o " +
                              folder.string() + " --picture-frame ";
  ASSERT_EQ(run_program(command + "0").code, 0);
  ASSERT_EQ(run_program(command + "9").code, 0);
  EXPECT_NE(read_file(folder / "pictures/step_0/0001.png"), read_file(folder / "pictures/step_9/0001.png"));
}

TEST(SweepCommand, ReportsWhatSimulateReports) {
  const fs::path scene = small_wall_file(), folder = fresh_folder("sweep"), stats = test_folder() / "stats.json";
  const std::string value = "projectiles/0/speed=60";
  ASSERT_EQ(run_program(sweep_of(scene, folder, "--frames 20 --vary " + value)).code, 0);
  ASSERT_EQ(
      run_program("simulate " + scene.string() + " --frames 20 --set " + value + " --stats " + stats.string()).code, 0);
  const auto told = nlohmann::json::parse(read_file(stats));
  const RunRecord record = record_from_json(read_file(folder / "runs" / "0001.json"), "");
  const auto outcome = [&](const char* key) { return record.outcomes.at(outcome_index(key, "")); };
  EXPECT_GT(outcome("pieces"), 1);
  EXPECT_EQ(outcome("pieces"), told["bodies"]);
  EXPECT_EQ(outcome("fragments"), told["fragments"]);
  EXPECT_EQ(outcome("crack_events"), told["crack_events"]);
  EXPECT_EQ(outcome("crack_area"), told["energy"]["crack_area"]);
  EXPECT_EQ(outcome("cracks"), told["crack_events"]);
  EXPECT_EQ(outcome("kinetic_energy"), told["kinetic_energy"]);
  EXPECT_EQ(outcome("energy.elastic"), told["energy"]["elastic"]);
  EXPECT_EQ(outcome("energy.contacts"), told["energy"]["contacts"]);
  EXPECT_EQ(outcome("momentum.2"), told["momentum"][2]);
  EXPECT_EQ(outcome("substeps"), told["substeps"]);
  EXPECT_EQ(outcome("energy_unaccounted"), told["energy"]["unaccounted"]);
  EXPECT_EQ(outcome("torn_supports"), told["supports_torn"]);
  EXPECT_GT(outcome("peak_utilization"), 1);
  EXPECT_LE(outcome("mass_p10"), outcome("mass_p90"));
  EXPECT_LE(outcome("first_crack_time"), outcome("breaking_time"));
}

TEST(SweepCommand, WritesARowARunInTheOrderOfThePlanWhateverTheJobs) {
  const fs::path scene = small_wall_file(), one = fresh_folder("one"), three = fresh_folder("three");
  const std::string plan = "--frames 5 --vary projectiles/0/speed=1:30 --vary ground=null,{} --latin-hypercube 3";
  ASSERT_EQ(run_program(sweep_of(scene, one, plan + " --jobs 1")).code, 0);
  ASSERT_EQ(run_program(sweep_of(scene, three, plan + " --jobs 3")).code, 0);
  EXPECT_EQ(csv_in(one), csv_in(three));
  const std::vector<std::string> lines = lines_of(csv_in(one));
  ASSERT_EQ(lines.size(), 7u);
  EXPECT_TRUE(lines[0].starts_with("run,projectiles/0/speed,ground,pieces,fragments,"));
  EXPECT_TRUE(lines[6].starts_with("6,"));
}

/// Records of runs in a sweep's folder, with when they were written.
std::map<fs::path, fs::file_time_type> records_in(const fs::path& folder) {
  std::map<fs::path, fs::file_time_type> records;
  if (!fs::exists(folder / "runs")) return records;
  for (const auto& entry : fs::directory_iterator(folder / "runs"))
    if (entry.path().extension() == ".json") records[entry.path()] = entry.last_write_time();
  return records;
}

/// Starts a sweep and kills it as soon as its folder holds a number of records; returns its exit code, 137 if it was
/// killed.
int run_until_records(const std::string& sweep, const fs::path& folder, std::size_t records) {
  const std::string count = "$(ls " + (folder / "runs").string() + " 2>/dev/null | grep -c '[.]json$')";
  return run_program(sweep, "run() { \"$@\" & until [ " + count + " -ge " + std::to_string(records) +
                                " ] || ! kill -0 $!; do sleep .002; done; kill -KILL $!; wait $!; exit $?; }; run")
      .code;
}

/// A sweep that is killed at random moments and continued to its end has the table of an undisturbed one, and no
/// finished run is repeated.
TEST(SweepCommand, ThatIsKilledLosesNothingAndDoesNothingTwice) {
  const fs::path scene = small_wall_file(), undisturbed = fresh_folder("calm"), killed = fresh_folder("killed");
  const std::string plan = "--frames 20 --vary projectiles/0/speed=5:60:8 --vary bodies/0/material/density=1500,2500";
  ASSERT_EQ(run_program(sweep_of(scene, undisturbed, plan)).code, 0);
  std::mt19937 random(1);
  std::map<fs::path, fs::file_time_type> done;
  int kills = 0;
  for (int code = -1; code != 0;) {
    code = run_until_records(sweep_of(scene, killed, plan), killed, done.size() + 1 + random() % 4);
    kills += code == 0 ? 0 : 1;
    ASSERT_LT(kills, 17);
    for (const auto& [file, time] : done) EXPECT_EQ(fs::last_write_time(file), time) << file;
    done = records_in(killed);
  }
  EXPECT_GT(kills, 1);
  EXPECT_EQ(done.size(), 16u);
  EXPECT_EQ(csv_in(killed), csv_in(undisturbed));
}

TEST(SweepCommand, ARunThatFailsIsARowAndIsMadeAgainOnRequestAlone) {
  const fs::path scene = small_wall_file(), folder = fresh_folder("sweep");
  const std::string plan = "--frames 5 --vary projectiles/0/speed=5,10";
  const Outcome starved = run_program(sweep_of(scene, folder, plan + " --memory-limit 16"));
  EXPECT_EQ(starved.code, 0) << starved.output;
  EXPECT_NE(starved.output.find("2 of them failed"), std::string::npos) << starved.output;
  EXPECT_FALSE(lines_of(csv_in(folder))[1].ends_with(",")) << csv_in(folder);
  run_program(sweep_of(scene, folder, plan));
  EXPECT_FALSE(lines_of(csv_in(folder))[1].ends_with(","));
  run_program(sweep_of(scene, folder, plan + " --retry"));
  EXPECT_TRUE(lines_of(csv_in(folder))[1].ends_with(",")) << csv_in(folder);
}

TEST(SweepCommand, RefusesAFolderOfAnotherSweepAndSaysWhatDiffers) {
  const fs::path scene = small_wall_file(), folder = fresh_folder("sweep");
  ASSERT_EQ(run_program(sweep_of(scene, folder, "--frames 1 --vary projectiles/0/speed=5,10")).code, 0);
  const Outcome other = run_program(sweep_of(scene, folder, "--frames 2 --vary projectiles/0/speed=5,10"));
  EXPECT_EQ(other.code, 2);
  EXPECT_NE(other.output.find("frames is 1 there and 2 now"), std::string::npos) << other.output;
}

TEST(SweepCommand, KeepsASecondSweepOutOfItsFolder) {
  const fs::path scene = small_wall_file(), folder = fresh_folder("sweep");
  fs::create_directories(folder);
  const Descriptor held(open(folder.c_str(), O_RDONLY | O_DIRECTORY));
  ASSERT_EQ(flock(held.number(), LOCK_EX), 0);
  const Outcome second = run_program(sweep_of(scene, folder, "--frames 1 --vary projectiles/0/speed=5"));
  EXPECT_EQ(second.code, 2);
  EXPECT_NE(second.output.find("another process"), std::string::npos) << second.output;
}

TEST(SweepCommand, RefusesBadScenesBeforeAnyRun) {
  const fs::path scene = small_wall_file(), folder = fresh_folder("sweep");
  for (const char* plan : {"projectiles/0/sped=1,2", "projectiles/0/speed=1,-2", "projectiles/3/speed=1,2"}) {
    const Outcome refused = run_program(sweep_of(scene, folder, std::string("--frames 1 --vary ") + plan));
    EXPECT_EQ(refused.code, 2) << plan;
    EXPECT_NE(refused.output.find("#/projectiles/"), std::string::npos) << refused.output;
    EXPECT_FALSE(fs::exists(folder)) << plan;
  }
}

TEST(SweepCommand, ItsJobsRunUnderGnuParallel) {
  if (std::system("parallel --version 2>&1 | grep -q 'GNU parallel'") != 0) GTEST_SKIP() << "no GNU parallel";
  const fs::path scene = small_wall_file(), here = fresh_folder("here"), there = fresh_folder("there");
  const fs::path jobs = test_folder() / "jobs.txt";
  const std::string plan = "--frames 5 --vary projectiles/0/speed=5,10,20 --set 'name=\"it'\"'\"'s\"'";
  ASSERT_EQ(run_program(sweep_of(scene, here, plan)).code, 0);
  ASSERT_EQ(run_program(sweep_of(scene, there, plan + " --list-jobs " + jobs.string())).code, 0);
  EXPECT_EQ(lines_of(read_file(jobs)).size(), 3u);
  EXPECT_TRUE(fs::is_empty(there / "runs"));
  ASSERT_EQ(std::system(("parallel -j2 < " + jobs.string() + " > /dev/null 2>&1").c_str()), 0);
  ASSERT_EQ(std::system(("sed -n 2p " + jobs.string() + " | sh").c_str()), 0);
  ASSERT_EQ(run_program(sweep_of(scene, there, plan + " --collect")).code, 0);
  EXPECT_EQ(csv_in(there), csv_in(here));
}

TEST(SweepCommand, ItsPageNeedsNothingElseAndNamesTheCommandOfEachRun) {
  const fs::path scene = small_wall_file(), folder = fresh_folder("sweep");
  ASSERT_EQ(
      run_program(sweep_of(scene, folder, "--frames 1 --vary projectiles/0/speed=5,10 --vary name='</script>'")).code,
      0);
  const std::string page = read_file(folder / "index.html");
  EXPECT_NE(page.find(scene.string() + " --set projectiles/0/speed=10"), std::string::npos);
  for (const char* outside : {"src=\"http", "href=", "@import", "url("})
    EXPECT_EQ(page.find(outside), std::string::npos);
  std::size_t ends = 0;
  for (std::size_t at = page.find("</script>"); at != std::string::npos; at = page.find("</script>", at + 1)) ++ends;
  EXPECT_EQ(ends, 2u);
}

TEST(FindCommand, BracketsTheSpeedAtWhichAWallBreaks) {
  const fs::path scene = small_wall_file(), report = test_folder() / "find.json";
  const Outcome found = run_program("find " + scene.string() +
                                    " --frames 20 --parameter projectiles/0/speed=1:100 --outcome 'pieces > 1' "
                                    "--tolerance 5% --report " +
                                    report.string());
  ASSERT_EQ(found.code, 0) << found.output;
  const auto told = nlohmann::json::parse(read_file(report));
  ASSERT_EQ(told["flips"].size(), 1u) << found.output;
  const auto& flip = told["flips"][0];
  EXPECT_TRUE(flip["above_holds"]);
  EXPECT_LE(flip["above"].get<double>() / flip["below"].get<double>(), 1.05);
  for (const char* side : {"below", "above"}) {
    const fs::path file = test_folder() / "outcomes.json";
    const std::string speed = number_text(flip[side].get<double>());
    ASSERT_NE(found.output.find("--set projectiles/0/speed=" + speed), std::string::npos) << found.output;
    run_program("simulate " + scene.string() + " --frames 20 --set projectiles/0/speed=" + speed + " --outcomes " +
                file.string());
    const double pieces = record_from_json(read_file(file), "").outcomes[outcome_index("pieces", "")];
    EXPECT_EQ(pieces > 1, side == std::string("above"));
  }
}

TEST(FindCommand, KnowsEveryQuantityOfTheStatistics) {
  const Outcome found = run_program("find " + small_wall_file().string() +
                                    " --frames 9 --parameter projectiles/0/speed=1,60 --outcome "
                                    "'cracks > 0, crack_area > 0, energy.contacts > 0, substeps >= 9, momentum.2 < 0'");
  EXPECT_EQ(found.code, 0) << found.output;
  EXPECT_NE(found.output.find("fails at 1"), std::string::npos) << found.output;
}

TEST(FindCommand, NarrowsFieldsWhoseRangeEndsBetweenWholeNumbers) {
  const Outcome found = run_program("find " + small_wall_file().string() +
                                    " --frames 0 --parameter bodies/0/material/poisson_ratio=0:0.4 --points 3 "
                                    "--outcome 'pieces > 1'");
  EXPECT_NE(found.output.find("0.2"), std::string::npos) << found.output;
}

TEST(FindCommand, RefusesSettingsThatTakeBackOthers) {
  const std::string common = "find " + small_wall_file().string() + " --frames 0 --parameter projectiles/0/speed=1,2 ";
  for (const char* more :
       {"--condition 'projectiles/0/speed=3: pieces == 1'", "--vary projectiles/0/speed=3,4 --outcome 'pieces > 1'"}) {
    const Outcome refused = run_program(common + more);
    EXPECT_EQ(refused.code, 2) << more << refused.output;
  }
}

TEST(FindCommand, ReportsProbabilitiesAndWhereConditionsFail) {
  const fs::path scene = small_wall_file();
  const std::string scatter = " --set 'bodies/0/strength_scatter={\"weibull_modulus\": 8}' --seeds 3";
  const Outcome chances = run_program("find " + scene.string() + " --frames 20 --parameter projectiles/0/speed=0,80 " +
                                      "--outcome 'pieces > 1'" + scatter);
  EXPECT_NE(chances.output.find("0/3 = 0.00 [0.00, 0.56]"), std::string::npos) << chances.output;
  EXPECT_NE(chances.output.find("3/3 = 1.00 [0.44, 1.00]"), std::string::npos) << chances.output;
  const Outcome none = run_program("find " + scene.string() + " --frames 2 --parameter projectiles/0/speed=1,2 " +
                                   "--condition 'projectiles/0/mass=2: pieces == 1' --condition 'pieces > 1000'");
  EXPECT_EQ(none.code, 1);
  EXPECT_NE(none.output.find("\"pieces > 1000\" fails at 2 of 2"), std::string::npos) << none.output;
}

}  // namespace
}  // namespace griffith::app
