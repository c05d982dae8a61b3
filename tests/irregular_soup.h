#pragma once

#include <utility>

#include "sim/meshing/mesh_surface.h"

namespace griffith::testing {

/// Some thousand tets of many shapes: the bear of the scenes, filled with tets of about 0.2 m.
inline TetSoup irregular_soup() {
  MeshingOptions options;
  options.method = MeshingMethod::volumetric;
  options.element_size = 0.2;
  return std::move(mesh_surface(read_surface(GRIFFITH_SOURCE_DIR "/scenes/meshes/bear.obj"), options).soup);
}

}  // namespace griffith::testing
