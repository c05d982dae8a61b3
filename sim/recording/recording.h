#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/recording/file_tree.h"
#include "sim/recording/versions.h"
#include "sim/scene/scene.h"
#include "sim/scene/world_input.h"
#include "sim/world/state/state_hashes.h"

namespace griffith {

class Timeline;
class World;

/// Run that can be repeated anywhere and compared step by step. Its file is a tar archive, compressed by Zstandard, of
///   scene.json     scene of the world; opens like any other
///   assets/        files of the scene, and the meshes that filled its surfaces
///   inputs.json    shots, grabs and changes of material, with their steps
///   hashes.csv     hashes of the state, one row per step, starting with step 0
///   versions.json  versions of program and system
/// and any extras.
struct Recording {
  Scene scene;  ///< paths lead only to `assets`
  FileTree assets;
  std::vector<WorldInput> inputs;   ///< inputs by step
  std::vector<StateHashes> hashes;  ///< hashes of the start and after each step
  Versions versions;
  FileTree extras;  ///< files not needed to repeat the run: a log, a picture

  std::int64_t steps() const { return std::ssize(hashes) - 1; }
};

/// Treatment of files that a scene names outside its folder, after all links are resolved. Without the user's consent
/// they must not be passed on in a recording.
enum class OutsideFiles { refuse, pack };
inline OutsideFiles outside_files(bool pack) { return pack ? OutsideFiles::pack : OutsideFiles::refuse; }

/// Returns a recording without steps, to be called before the first one. Reads all files that the scene is built from.
/// Throws InputError if one cannot be read any more, or if it is outside the scene's folder and `outside` refuses it.
Recording begin_recording(const World& world, OutsideFiles outside = OutsideFiles::refuse);
/// Returns the present branch of a timeline that began with the start of its world. Throws as begin_recording() does.
Recording record(const Timeline& timeline, OutsideFiles outside = OutsideFiles::refuse);

/// Returns all files of the recording, as its archive holds them.
FileTree files_of(const Recording& recording);
/// Writes the recording's file as replace_file() does. Throws InputError if that fails or the file would be too large.
void write_recording(const Recording& recording, const std::filesystem::path& path);

/// Reads a recording's file. Throws InputError, which names the archive and the file in it, if anything is missing or
/// damaged, if it would read files from elsewhere, and if its hashes have other fields than kStateFields.
Recording read_recording(const std::filesystem::path& path);

}  // namespace griffith
