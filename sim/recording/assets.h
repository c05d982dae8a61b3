#pragma once

#include "sim/recording/file_tree.h"
#include "sim/recording/recording.h"
#include "sim/scene/scene.h"
#include "sim/world/setup/in_memory_meshes.h"
#include "sim/world/world.h"

namespace griffith {

/// Scene whose paths lead only to `files`, each below its own folder, "assets/1/wall.msh".
struct SceneWithAssets {
  Scene scene;
  FileTree files;
};

/// Reads all files that the scene of a world is built from, and the files that these name in their own folders
/// (TetGen's pairs, buffers of glTF, materials of OBJ). Adds the mesh that filled each surface as "filled.msh" beside
/// it, since another version of TetGen would produce another mesh. Throws InputError for an unreadable file, and for a
/// file outside the scene's folder if `outside` refuses it.
SceneWithAssets collect_assets(const World& world, OutsideFiles outside = OutsideFiles::refuse);

/// Returns the meshes that collect_assets() put beside the surfaces of the scene, whose files are below scene.folder.
InMemoryMeshes filled_surfaces(const Scene& scene);

}  // namespace griffith
