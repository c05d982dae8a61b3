#include "sim/recording/recording.h"

#include <algorithm>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/file_content.h"
#include "sim/core/replace_file.h"
#include "sim/recording/assets.h"
#include "sim/recording/hash_table.h"
#include "sim/scene/scene_paths.h"
#include "sim/scene/scene_reader.h"
#include "sim/scene/scene_writer.h"
#include "sim/timeline/timeline.h"

namespace griffith {
namespace {

constexpr char kScene[] = "scene.json", kInputs[] = "inputs.json", kHashes[] = "hashes.csv",
               kVersions[] = "versions.json", kAssets[] = "assets/";

/// Returns the name of a file in a recording's file for errors.
std::string place_of(const std::filesystem::path& path, const std::string& member) {
  return path.string() + ": " + member;
}

/// Removes a file from the archive and returns its content. `max_bytes`: text takes many times its size in memory when
/// it is parsed.
std::string take_member(FileTree& files, const std::string& name, std::size_t max_bytes,
                        const std::filesystem::path& path) {
  const auto found = files.find(name);
  if (found == files.end())
    throw InputError(path.string(), "lacks \"" + name + "\"",
                     "is it a recording? griffith simulate --record writes one");
  if (found->second.size() > max_bytes)
    throw InputError(path.string(), "holds a \"" + name + "\" of " + std::to_string(found->second.size()) + " bytes",
                     "at most " + std::to_string(max_bytes) + " are read");
  return std::move(files.extract(found).mapped());
}

/// A scene from someone else must not read other files of this machine.
void require_own_files(Scene& scene, const FileTree& assets, const std::string& where) {
  for (const std::filesystem::path* path : paths_in(scene)) {
    const std::string name = path->generic_string();
    const auto inside = assets.lower_bound(name);  // the file itself, or content of the folder
    const bool held = inside != assets.end() && (inside->first == name || inside->first.starts_with(name + "/"));
    if (!held || !name.starts_with(kAssets))
      throw InputError(where, "names \"" + name + "\", which the recording does not hold",
                       "a recording holds all files of its scene below " + std::string(kAssets));
  }
}

/// Throws for inputs that World would take for errors of the program.
void require_possible(const Recording& recording, const std::string& where) {
  const auto bodies = static_cast<int>(recording.scene.bodies.size());
  for (const WorldInput& input : recording.inputs) {
    const auto* change = std::get_if<MaterialChange>(&input.action);
    const auto* burst = std::get_if<ProjectileBurst>(&input.action);
    if (input.step > recording.steps())
      throw InputError(where, "has an input of step " + std::to_string(input.step),
                       "the recording ends with step " + std::to_string(recording.steps()));
    if (change && change->scene_body >= bodies)
      throw InputError(where, "changes body " + std::to_string(change->scene_body),
                       "the scene has " + std::to_string(bodies));
    if (burst && burst->shape && std::holds_alternative<SurfaceProjectile>(*burst->shape))
      throw InputError(where, "fires a surface from a file", "inputs hold the points of what was fired");
  }
}

}  // namespace

Recording begin_recording(const World& world, OutsideFiles outside) {
  SceneWithAssets assets = collect_assets(world, outside);
  return {std::move(assets.scene), std::move(assets.files), {}, {world.state_hashes()}, versions_here(), {}};
}

Recording record(const Timeline& timeline, OutsideFiles outside) {
  Recording recording = begin_recording(timeline.world(), outside);
  recording.inputs = timeline.inputs();
  recording.hashes = timeline.hashes();
  return recording;
}

FileTree files_of(const Recording& recording) {
  FileTree files = recording.assets;
  files.insert(recording.extras.begin(), recording.extras.end());
  files[kScene] = scene_to_json(recording.scene);
  files[kInputs] = inputs_to_json(recording.inputs);
  files[kHashes] = hashes_to_csv(recording.hashes);
  files[kVersions] = versions_to_json(recording.versions);
  return files;
}

void write_recording(const Recording& recording, const std::filesystem::path& path) {
  replace_file(path, pack_files(files_of(recording), path.string()));
}

Recording read_recording(const std::filesystem::path& path) {
  constexpr std::string_view kZstd = "\x28\xb5\x2f\xfd";  // recognized by content, not by name
  const std::string packed = read_file(path);
  if (!packed.starts_with(kZstd)) require_expected_content(path, packed);
  FileTree files = unpack_files(packed, path.string());
  constexpr std::size_t kMegabyte = 1 << 20;
  const std::string scene = take_member(files, kScene, 16 * kMegabyte, path),
                    inputs = take_member(files, kInputs, 128 * kMegabyte, path),
                    hashes = take_member(files, kHashes, 512 * kMegabyte, path),
                    versions = take_member(files, kVersions, kMegabyte, path);
  Recording recording;
  recording.versions = versions_from_json(versions, place_of(path, kVersions));
  recording.hashes = hashes_from_csv(hashes, place_of(path, kHashes), version_of(recording.versions, "program"));
  recording.scene = scene_from_json_alone(scene, place_of(path, kScene));
  recording.inputs = inputs_from_json(inputs, place_of(path, kInputs));
  for (auto& [name, content] : files)
    (name.starts_with(kAssets) ? recording.assets : recording.extras)[name] = std::move(content);
  require_own_files(recording.scene, recording.assets, place_of(path, kScene));
  require_possible(recording, place_of(path, kInputs));
  return recording;
}

}  // namespace griffith
