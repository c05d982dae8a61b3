#pragma once

#include "sim/recording/file_tree.h"
#include "sim/recording/recording.h"
#include "sim/scene/scene.h"
#include "sim/world/setup/given_meshes.h"
#include "sim/world/world.h"

namespace griffith {

/// A scene whose paths lead to `files` alone, each below a folder of its own, "assets/1/wall.msh".
struct SceneWithAssets {
  Scene scene;
  FileTree files;
};

/// Reads all files that the scene of a world is built from, with those that they name themselves in their own folders
/// (TetGen's pairs, buffers of glTF, materials of OBJ). Beside each surface stands the mesh that filled it in this
/// world, "filled.msh": another version of TetGen would make another. Throws InputError for a file that cannot be read,
/// and for one outside the scene's folder where those are refused.
SceneWithAssets collect_assets(const World& world, OutsideFiles outside = OutsideFiles::refuse);

/// The meshes that collect_assets() put beside the surfaces of the scene, whose files are below scene.folder.
GivenMeshes filled_surfaces(const Scene& scene);

}  // namespace griffith
