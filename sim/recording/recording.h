#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/recording/file_tree.h"
#include "sim/recording/versions.h"
#include "sim/scene/scene.h"
#include "sim/scene/world_input.h"
#include "sim/world/state_hashes.h"

namespace griffith {

class Timeline;
class World;

/// A run, so that it can be made again anywhere and compared step by step. Its file is a tar archive, compressed by
/// Zstandard, of
///   scene.json     the scene that the world was built from, which opens like any other
///   assets/        the files that it is built from, and the meshes that filled its surfaces
///   inputs.json    shots and changes of material, with their steps
///   hashes.csv     hashes of the state, a row a step, the start first
///   versions.json  what made it
/// and whatever else was put beside them.
struct Recording {
  Scene scene;  ///< its paths lead to `assets` alone
  FileTree assets;
  std::vector<WorldInput> inputs;   ///< by step
  std::vector<StateHashes> hashes;  ///< of the start and after each step
  Versions versions;
  FileTree extras;  ///< not needed to make the run again: a log, a picture

  std::int64_t steps() const { return std::ssize(hashes) - 1; }
};

/// Files that a scene names, but that are not in its folder or below once links are resolved: who passes the recording
/// on may not know that they are in it.
enum class OutsideFiles { refuse, pack };

/// A recording of no steps yet: to be called before the first. Reads all files that the scene is built from. Throws
/// InputError for one that cannot be read any more, or is outside the scene's folder and not asked for.
Recording begin_recording(const World& world, OutsideFiles outside = OutsideFiles::refuse);
/// The present branch of a timeline that began with the start of its world. Throws as begin_recording().
Recording record(const Timeline& timeline);

/// All files of the recording, as its archive holds them.
FileTree files_of(const Recording& recording);
/// Writes the recording's file as replace_file() does. Throws InputError when that fails or it would be too large.
void write_recording(const Recording& recording, const std::filesystem::path& path);

/// Reads a recording's file. Throws InputError, which names the archive and the file in it, where anything is missing,
/// damaged, or would read files from elsewhere, and where its hashes are of other fields than kStateFields.
Recording read_recording(const std::filesystem::path& path);

}  // namespace griffith
