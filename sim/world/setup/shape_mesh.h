#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "sim/contact/contact_world.h"
#include "sim/core/monitor.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/scene/scene.h"
#include "sim/scene/shape.h"
#include "sim/world/setup/in_memory_meshes.h"

namespace griffith {

/// Mesh of a shape in its own frame, and data that are the same for all bodies of the shape.
struct ShapeMesh {
  TetSoup soup;                                   ///< prepared
  std::shared_ptr<const TetSoup> filled_surface;  ///< original soup of a filled surface; null for other shapes
  std::vector<int> point_of_node;                 ///< per node of the soup: the point as read that it was
  TetMesh mesh;                                   ///< mesh of the soup
  std::vector<std::vector<TetId>> pieces;         ///< sets of tets connected through faces
  std::vector<NodeId> slit_tips;                  ///< crack fronts that it has from the start
  std::vector<ConvexPart> convex_parts;  ///< parts of one piece, relative to its center of mass [m]; empty for several
  std::vector<std::string> findings;     ///< oddities of a file for the user
};

/// Meshes of a scene's shapes, each read or made once.
class ShapeMeshes {
 public:
  ShapeMeshes() = default;
  /// Knows meshes that need no file; they must live as long as this.
  explicit ShapeMeshes(const InMemoryMeshes& given) : given_(&given) {}

  /// Returns the mesh of the body's shape, by a reference that stays valid. Throws InputError, with body and file, for
  /// one that cannot be simulated, and Cancelled if the monitor requests it.
  const ShapeMesh& of(const Scene& scene, int scene_body, const Monitor& monitor);

 private:
  /// Hash of the properties in which most shapes differ.
  struct Hash {
    std::size_t operator()(const Shape& shape) const;
  };
  const InMemoryMeshes* given_ = nullptr;
  std::unordered_map<Shape, ShapeMesh, Hash> made_;
};

/// Returns the JSON pointer of a body's shape in a scene file.
std::string shape_pointer(const Scene& scene, int scene_body);

/// Returns the tets of a shape in the body's rest space [m], to be prepared (mesh_report.h). Relative paths start at
/// `folder`. A surface is filled, or its mesh is taken from the cache. `findings` receives oddities of the file for the
/// user, a sentence each. Throws InputError if the mesh cannot be made or read, and Cancelled if the monitor requests
/// it.
TetSoup make_soup(const Shape& shape, const std::filesystem::path& folder, std::vector<std::string>* findings = nullptr,
                  const Monitor& monitor = {});

}  // namespace griffith
