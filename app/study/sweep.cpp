#include "app/study/sweep.h"

#include <algorithm>
#include <cstdio>

#include "app/shared/processes.h"
#include "sim/scene/scene_reader.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;

/// Returns a file name: "0001.json", with at least four digits and as many as the last run's number has.
std::string numbered_name(const Sweep& sweep, std::size_t run, const char* extension) {
  const int digits = std::max<int>(4, static_cast<int>(std::to_string(sweep.size()).size()));
  char name[64];
  std::snprintf(name, sizeof name, "%0*zu%s", digits, run + 1, extension);
  return name;
}

/// Throws InputError for runs whose scene cannot be read, before any run is made.
void check_runs(const Sweep& sweep) {
  for (std::size_t run = 0; run < sweep.size(); ++run) read_scene(sweep.definition.scene, sweep.request(run).settings);
}

}  // namespace

RunRequest Sweep::request(std::size_t run) const {
  RunRequest request{program, definition.scene, settings, definition.frames};
  for (SceneSetting& setting : settings_of(plan.parameters, plan.runs[run])) request.settings.push_back(setting);
  return request;
}

fs::path Sweep::record_file(std::size_t run) const { return folder / "runs" / numbered_name(*this, run, ".json"); }

fs::path Sweep::picture_file(std::size_t run) const {
  return folder / "pictures" / ("step_" + std::to_string(picture_frame.value())) / numbered_name(*this, run, ".png");
}

Sweep make_sweep(const SweepDefinition& definition, const fs::path& folder) {
  Sweep sweep{definition, {}, {}, folder, this_program(), {}};
  for (const std::string& text : definition.set) sweep.settings.push_back(read_setting(text, "--set"));
  const Scene scene = read_scene(definition.scene, sweep.settings);
  std::vector<Parameter> parameters;
  for (const std::string& text : definition.vary) parameters.push_back(read_parameter(text, "--vary"));
  if (definition.seeds > 0) parameters.push_back(seed_parameter(scene, definition.seeds));
  sweep.plan = make_plan(std::move(parameters), definition.samples, definition.seed);
  check_runs(sweep);
  return sweep;
}

std::string job_list(const Sweep& sweep) {
  std::string list;
  for (std::size_t run = 0; run < sweep.size(); ++run) {
    const auto line = [&](const fs::path& file, const std::vector<std::string>& words) {
      return "{ [ -e " + shell_command({file.string()}) + " ] || " + shell_command(words) + "; }";
    };
    list += line(sweep.record_file(run), simulate_words(sweep.request(run), sweep.record_file(run)));
    if (sweep.picture_frame)
      list += " && " + line(sweep.picture_file(run),
                            render_words(sweep.request(run), *sweep.picture_frame, sweep.picture_file(run)));
    list += "\n";
  }
  return list;
}

}  // namespace griffith::app
