#pragma once

#include <functional>

#include "sim/world/state/world_state.h"
#include "tests/validation/validation_case.h"

namespace griffith::validation {

inline constexpr std::array<BoxPattern, 3> kPatterns = {BoxPattern::kuhn, BoxPattern::five_tet, BoxPattern::bcc};

/// "kuhn", resolution "n = 4".
MeshLabel mesh_label(BoxPattern pattern, int cells);

/// The scene scenes/validation/`name`.json.
Scene validation_scene(const std::string& name);

/// The stress that pulls a node apart, and across which plane.
struct Separation {
  double stress = 0;  ///< s [Pa]
  Vec3 normal = Vec3::UnitX();
};

/// The only body of a scene, laid open: deform it, or bring it into equilibrium, and look at every node and tet.
class Specimen {
 public:
  explicit Specimen(const Scene& scene);

  /// Moves every node to map(rest position).
  void deform(const std::function<Vec3(const Vec3&)>& map);
  /// Static equilibrium under gravity and the loads of the time 0. Throws std::runtime_error when it is not found.
  void equilibrate();

  int node_count() const { return world_.mesh->node_count(); }
  const TetMesh& mesh() const { return world_.mesh; }
  const Vec3& rest_position(int node) const { return world_.mesh->rest_positions[node]; }
  Vec3 displacement(int node) const { return world_.nodes.positions[node] - world_.mesh->rest_positions[node]; }
  std::span<const Mat3> stresses() const { return world_.elements.stresses; }
  /// Per node [N].
  std::vector<Vec3> elastic_forces() const;
  Separation separation(int node) const;

  /// The nodes whose rest positions fulfil a condition.
  std::vector<int> nodes_where(const std::function<bool(const Vec3&)>& condition) const;
  /// Everything else, for cases that step through time themselves.
  WorldState& world() { return world_; }

 private:
  WorldState world_;
};

}  // namespace griffith::validation
