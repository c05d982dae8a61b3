#pragma once

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "sim/contact/contact_world.h"
#include "sim/core/monitor.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/scene/scene.h"
#include "sim/world/setup/in_memory_meshes.h"

namespace griffith {

/// The mesh of a shape in its own frame, and what is known of it: the same for all bodies of the shape.
struct ShapeMesh {
  TetSoup soup;                                   ///< prepared
  std::shared_ptr<const TetSoup> filled_surface;  ///< as it was made; null for what is no surface
  std::vector<int> point_of_node;                 ///< per node of the soup: the point as read that it was
  TetMesh mesh;                                   ///< of the soup
  std::vector<std::vector<TetId>> pieces;         ///< what holds together through faces
  std::vector<NodeId> slit_tips;                  ///< crack fronts that it has from the start
  std::vector<ConvexPart>
      convex_parts;                   ///< of one piece, relative to its center of mass [m]; empty if it is in several
  std::vector<std::string> findings;  ///< what the user should know of a file
};

/// The meshes of a scene's shapes, each read or made once.
class ShapeMeshes {
 public:
  ShapeMeshes() = default;
  /// Knows meshes that need no file; they must live as long as this.
  explicit ShapeMeshes(const InMemoryMeshes& given) : given_(&given) {}

  /// The mesh of the body's shape; it stays where it is. Throws InputError, which names the body and the file, for one
  /// that cannot be simulated, Cancelled when the monitor says so.
  const ShapeMesh& of(const Scene& scene, int scene_body, const Monitor& monitor);

 private:
  /// By what tells most shapes apart.
  struct Hash {
    std::size_t operator()(const Shape& shape) const;
  };
  const InMemoryMeshes* given_ = nullptr;
  std::unordered_map<Shape, ShapeMesh, Hash> made_;
};

/// Where in a scene file the shape of a body is, as a JSON pointer.
std::string shape_pointer(const Scene& scene, int scene_body);

}  // namespace griffith
