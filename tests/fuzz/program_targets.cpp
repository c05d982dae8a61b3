#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

#include "app/cli/command_line.h"
#include "app/editor/script.h"
#include "app/output/id_picture.h"
#include "app/regress/report.h"
#include "app/regress/run_suite.h"
#include "app/regress/suite.h"
#include "app/render/picture_output.h"
#include "app/render/read_render_jobs.h"
#include "app/study/outcome_table.h"
#include "app/study/sweep_folder.h"
#include "app/study/sweep_page.h"
#include "sim/core/parallel.h"
#include "sim/core/temporary_folder.h"
#include "sim/recording/recording.h"
#include "sim/scene/scene_reader.h"
#include "sim/world/world.h"
#include "tests/fuzz/mutate_bytes.h"
#include "tests/fuzz/mutate_json.h"
#include "tests/fuzz/small_scenes.h"
#include "tests/fuzz/target.h"

// Other input of the program than scenes and meshes: jobs, suites, sweeps, scripts and its own arguments.

namespace griffith::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr char kWall[] =
    R"({"version": 1, "name": "wall", "bodies": [{"name": "wall", "shape": {"box": {"size": [1, 1, 0.25], "element_size": 0.5}},
     "position": [0, 0.5, 0], "material": "concrete"}], "projectiles": [{"position": [0, 0.5, 1], "direction": [0, 0, -1], "speed": 20}],
     "probes": [{"name": "=top", "body": "wall", "at": {"point": [0, 0.5, 0]}, "quantities": ["displacement"]}],
     "cameras": [{"name": "front", "position": [0, 1, 4], "target": [0, 0.5, 0]}]})";

bool has_controls(std::string_view text) {
  return std::ranges::any_of(text, [](unsigned char c) { return (c < ' ' && c != '\n' && c != '\t') || c == 0x7F; });
}

/// The document's text after changes to its values, or to its bytes.
std::string mutate_document(const std::string& text, RandomValues& random) {
  static const Vocabulary kNone;
  if (chance(random, 0.4)) return mutate_file(text, random);
  const Json document = Json::parse(text);
  return mutate_scene(document, document, kNone, random);
}

/// Lists of pictures to draw.
class JobsTarget : public Target {
 public:
  std::string name() const override { return "jobs"; }
  int fraction() const override { return 60; }

  Input make(RandomValues& random) const override {
    return {"input.json", {{"input.json", mutate_document(jobs_, random)}}};
  }

  Outcome run(const Input& input, const fs::path& folder) const override {
    const std::vector<app::RenderJob> jobs = app::read_render_jobs(folder / input.entry);
    for (const app::RenderJob& job : jobs)
      for (const std::string& name : app::picture_names(job))
        promise(fs::path(name).filename() == name && !has_controls(name), "a picture would have an odd name: " + name);
    std::ofstream(folder / "again.json") << app::render_jobs_json(jobs, folder);
    promise(app::read_render_jobs(folder / "again.json").size() == jobs.size(), "written and read, there are others");
    return Outcome::ran;
  }

 private:
  std::string jobs_ = read_file(GRIFFITH_SOURCE_DIR "/tests/pictures/suite.json");
};

/// Suites with pictures that somebody else accepted.
class SuiteTarget : public Target {
 public:
  SuiteTarget() {
    render::Image image{24, 16, std::vector<std::uint8_t>(24 * 16 * 4, 200)};
    render::IdImage ids{24, 16, std::vector<std::int32_t>(24 * 16, 3)};
    app::PictureRecord record;
    record.view = "utilization";
    record.scene = kWall;
    record.statistics = {{"pieces", 3}};
    for (const char* at : {"goldens/llvmpipe/", "drawn/"}) {
      const std::string stem = std::string(at) + "wall";
      files_[stem + ".png"] = render::encode_png(image);
      files_[stem + ".ids.png"] = render::encode_png(app::id_picture(ids));
      files_[stem + ".txt"] = "label: 3 pieces\n";
      files_[stem + ".json"] = app::record_json(record, "llvmpipe");
    }
    files_["input.json"] = R"({"pictures": [{"name": "wall", "scene": "wall.json", "views": ["utilization"]}]})";
  }

  std::string name() const override { return "suite"; }
  int fraction() const override { return 60; }

  Input make(RandomValues& random) const override {
    Input input{"input.json", files_};
    auto file = std::next(input.files.begin(), random.index(static_cast<int>(files_.size())));
    const bool json = file->first.ends_with(".json");
    if (chance(random, 0.1) && file->first != input.entry) {
      input.files.erase(file);
    } else {
      file->second = json ? mutate_document(file->second, random) : mutate_file(file->second, random);
    }
    return input;
  }

  Outcome run(const Input& input, const fs::path& folder) const override {
    fs::rename(folder / input.entry, folder / app::kSuiteFile);
    const std::vector<app::RenderJob> jobs = app::suite_jobs(folder, {});
    app::SuiteRun suite;
    suite.suite = folder;
    suite.drawn = folder / "drawn";
    std::vector<app::PictureResult> results;
    for (const app::RenderJob& job : jobs)
      for (app::PictureResult& result : app::compare_job(suite, job, {})) results.push_back(std::move(result));
    promise(!has_controls(app::junit_xml("suite", results)), "a report has control characters");
    app::report_html({"suite", "llvmpipe", "1", "", 1}, results);
    app::unused_goldens(folder, "llvmpipe", jobs);
    return Outcome::ran;
  }

 private:
  std::map<std::string, std::string> files_;
};

/// Sweeps that somebody else began.
class SweepTarget : public Target {
 public:
  SweepTarget() {
    const ThreadLimit one(1);
    const TemporaryFolder folder;
    write_input({"input.json", {{"input.json", kWall}}}, folder.path() / "input");
    app::prepare_folder(sweep_in(folder.path() / "input"));
    plan_ = read_file(folder.path() / "input/sweep/plan.json");
    record_ = app::record_json({app::Outcomes(app::outcome_kinds().size(), 1.5), ""});
  }

  std::string name() const override { return "sweep"; }
  int fraction() const override { return 60; }

  Input make(RandomValues& random) const override {
    Input input{"input.json", {{"input.json", kWall}, {"sweep/plan.json", plan_}}};
    for (const char* run : {"sweep/runs/0001.json", "sweep/runs/0002.json"}) input.files[run] = record_;
    input.files["sweep/runs/0002.json"] = app::record_json({{}, "=it \x1b[31mfailed, \"badly\""});
    const std::array names = {"sweep/plan.json", "sweep/runs/0001.json", "sweep/runs/0002.json"};
    std::string& text = input.files[pick(random, names)];
    text = mutate_document(text, random);
    return input;
  }

  Outcome run(const Input&, const fs::path& folder) const override {
    const app::Sweep sweep = sweep_in(folder);
    const app::FolderLock lock(sweep.folder);
    app::prepare_folder(sweep);
    const auto records = app::read_records(sweep);
    app::missing_runs(sweep);
    const std::string csv = app::outcome_csv(sweep, records);
    promise(csv.find("\n=") == std::string::npos && csv.find(",=") == std::string::npos, "a table holds a formula");
    promise(!has_controls(app::sweep_page(sweep, records, "")), "a page has control characters");
    app::remove_failed_records(sweep);
    return Outcome::ran;
  }

 private:
  static app::Sweep sweep_in(const fs::path& folder) {
    app::SweepDefinition definition;
    definition.scene = folder / "input.json";
    definition.frames = 2;
    definition.vary = {"projectiles/0/speed=5:10:2"};
    return app::make_sweep(definition, folder / "sweep");
  }

  std::string plan_, record_;
};

/// Scripts for the editor.
class ScriptTarget : public Target {
 public:
  std::string name() const override { return "script"; }
  int fraction() const override { return 60; }

  Input make(RandomValues& random) const override {
    return {"input.script", {{"input.script", mutate_file(tour_, random)}}};
  }

  Outcome run(const Input& input, const fs::path& folder) const override {
    app::read_script(folder / input.entry);
    return Outcome::ran;
  }

 private:
  std::string tour_ = read_file(GRIFFITH_SOURCE_DIR "/app/editor/tour.script");
};

/// Command lines, one argument a line, most of them good; "@" stands for the input's folder.
class CommandTarget : public Target {
 public:
  std::string name() const override { return "command"; }
  int fraction() const override { return 60; }

  Input make(RandomValues& random) const override {
    std::string text;
    std::vector<std::string> words = command_line(random);
    if (chance(random, 0.25)) {  // the command itself stays: without one a window would open
      std::string& word = words[1 + static_cast<std::size_t>(random.index(static_cast<int>(words.size()) - 1))];
      word = mutate_text(word, random);
      std::erase(word, '\n');
    }
    for (const std::string& word : words) text += word + "\n";
    Input input{"input.txt", small_files()};
    input.files["input.txt"] = text;
    input.files["wall.json"] = kWall;
    input.files["run.tar.zst"] = run_;
    return input;
  }

  Outcome run(const Input& input, const fs::path& folder) const override {
    std::vector<std::string> words = {"griffith"};
    std::istringstream lines(input.files.at(input.entry));
    for (std::string word; std::getline(lines, word);) {
      if (const auto at = word.find('@'); at != std::string::npos) word.replace(at, 1, folder.string());
      words.push_back(word);
    }
    constexpr std::array kKnown = {"simulate", "check", "export", "replay", "mesh", "sweep"};
    if (words.size() < 2 || std::ranges::find(kKnown, words[1]) == kKnown.end()) return Outcome::refused;
    std::vector<const char*> arguments;
    for (const std::string& word : words) arguments.push_back(word.c_str());
    const int code = app::run(static_cast<int>(arguments.size()), arguments.data());
    promise(code == app::kDone || code == app::kBadInput, "the exit code is " + std::to_string(code));
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      promise(!entry.path().filename().string().starts_with(".griffith_"), "a temporary file is left");
    return code == app::kDone ? Outcome::ran : Outcome::refused;
  }

 private:
  static std::vector<std::string> simulation(RandomValues& random) {
    const std::array<std::vector<std::string>, 12> more = {{{"--stats", "@/stats.json"},
                                                            {"--probes", "@/probes.csv"},
                                                            {"--energy", "@/energy.csv"},
                                                            {"--events", "@/events.json"},
                                                            {"--export", "@/end.vtu"},
                                                            {"--export", "@/end.msh"},
                                                            {"--export-pieces", "@/pieces"},
                                                            {"--outcomes", "@/outcomes.json"},
                                                            {"--record", "@/new.tar.zst"},
                                                            {"--threads", "1"},
                                                            {"--set", "projectiles/0/speed=3"},
                                                            {"--set", "gravity=[0,0,0]"}}};
    std::vector<std::string> words = {"simulate", "@/wall.json", "--frames", std::to_string(random.index(4))};
    for (const auto& option : more)
      if (chance(random, 0.25)) words.insert(words.end(), option.begin(), option.end());
    return words;
  }

  static std::vector<std::string> command_line(RandomValues& random) {
    switch (random.index(8)) {
      case 0:
        return {"check", "@/wall.json"};
      case 1:
        return {"export",   "@/wall.json",
                "--frames", "0:2",
                "-o",       "@/run." + pick(random, std::vector<std::string>{"glb", "usda", "html", "json", "csv"})};
      case 2:
        return {"replay", "@/run.tar.zst"};
      case 3:
        return {"replay", "@/run.tar.zst", "--extract", "@/out"};
      case 4:
        return {"mesh", "@/box.off", "--element-size", "0.5", "--method", "volumetric", "-o", "@/box.vtu"};
      case 5:
        return {"sweep", "@/wall.json", "--frames",    "2",         "--vary", "projectiles/0/speed=1,2",
                "-o",    "@/sweep",     "--list-jobs", "@/jobs.txt"};
      default:
        return simulation(random);
    }
  }

  static std::string recorded_run() {
    const ThreadLimit one(1);
    World world(scene_from_json(kWall));
    Recording recording = begin_recording(world);
    world.step();
    recording.hashes.push_back(world.state_hashes());
    return pack_files(files_of(recording), "recording");
  }

  std::string run_ = recorded_run();
};

}  // namespace

std::unique_ptr<Target> make_jobs_target() { return std::make_unique<JobsTarget>(); }
std::unique_ptr<Target> make_suite_target() { return std::make_unique<SuiteTarget>(); }
std::unique_ptr<Target> make_sweep_target() { return std::make_unique<SweepTarget>(); }
std::unique_ptr<Target> make_script_target() { return std::make_unique<ScriptTarget>(); }
std::unique_ptr<Target> make_command_target() { return std::make_unique<CommandTarget>(); }

}  // namespace griffith::fuzz
