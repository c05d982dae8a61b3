#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/cli/commands.h"
#include "app/output/open_world.h"
#include "app/output/output.h"
#include "app/shared/scene_warnings.h"
#include "app/shared/scene_world.h"
#include "sim/core/error.h"
#include "sim/scene/scene_reader.h"

namespace griffith::app {
namespace {

/// Prints the elements of bodies whose scene leaves the choice.
void print_element_choices(const Scene& scene, const World& world) {
  const auto choices = world.frame().element_choices;
  for (std::size_t i = 0; i < choices.size(); ++i)
    if (choices[i].automatic)
      print("body \"%s\": elements are %s\n", printable(scene.bodies[i].name).c_str(), text_of(choices[i]).c_str());
}

/// Prints the file's warnings and returns all its problems; if there are none, the first problem of its meshes.
std::vector<InputError> problems_of(const std::filesystem::path& path, std::span<const SceneSetting> settings) {
  std::vector<InputError> problems = check_scene(path, settings);
  if (!problems.empty()) return problems;
  try {
    const Scene scene = read_scene(path, settings);
    const World world = make_world(scene, path);
    print_warnings(path, outdated_names(path));
    print_warnings(path, scene_warnings(scene, world));
    print_element_choices(scene, world);
  } catch (const InputError& error) {
    problems.push_back(error);
  }
  return problems;
}

/// Prints all problems and warnings of every scene. Returns the number of problems.
int count_problems(const std::vector<std::filesystem::path>& scenes, std::span<const SceneSetting> settings) {
  int count = 0;
  for (const std::filesystem::path& path : scenes) {
    const std::vector<InputError> problems = problems_of(path, settings);
    for (const InputError& problem : problems) print_error("%s\n", printable(problem.what()).c_str());
    if (problems.empty()) print("%s: valid\n", path.c_str());
    count += static_cast<int>(problems.size());
  }
  if (count > 0) print_error("%d %s\n", count, count == 1 ? "problem" : "problems");
  return count;
}

}  // namespace

Command add_check(CLI::App& program) {
  CLI::App* command = program.add_subcommand("check", "List every problem of scene files");
  const auto scenes = std::make_shared<std::vector<std::filesystem::path>>();
  const auto set = std::make_shared<std::vector<std::string>>();
  command->add_option("SCENE", *scenes, "Scene files")->required()->type_name("FILE");
  add_settings(*command, *set);
  command->footer("Example:\n  griffith check scenes/wall_small.json scenes/materials.json");
  return {command, [scenes, set] { return count_problems(*scenes, settings(*set)) == 0 ? kDone : kBadInput; }};
}

}  // namespace griffith::app
