#pragma once

#include "sim/core/error.h"
#include "sim/scene/boundary_condition.h"
#include "sim/world/setup/rest_body.h"

namespace griffith {

struct WorldState;

/// A load and what it acts on: one of the three lists, by its kind.
struct PlacedLoad {
  Load load;
  std::vector<TetCorner> corners;  ///< one a node: the force stays with this piece of material
  std::vector<SurfaceFace> faces;  ///< of the surface before anything broke
  std::vector<TetId> tets;
};

/// Which part of a load acts at a time [s]: 0 before its start and after its end, else up to 1.
double load_factor(const Load& load, double time);

/// Finds what a body's loads act on; one that acts on nothing becomes a finding.
void place_loads(WorldState& world, int scene_body, const RestBody& body, std::vector<InputError>& findings);

/// Ends the rest of rigid bodies on which a load has changed between `before` and `time` [s].
void make_loaded_bodies_elastic(WorldState& world, double before, double time);

/// Adds the forces of all loads at `time` [s] to `forces`, per node [N]. Their sums are exact: a point force adds up to
/// itself, a traction to itself times the undeformed area; a uniform pressure on a closed surface has no resultant. A
/// face's load goes in equal parts to its corners, which keeps its torque too.
void add_load_forces(const WorldState& world, double time, std::vector<Vec3>& forces);
/// Adds the forces of loads that do not depend on the positions: all but pressures.
void add_dead_forces(const WorldState& world, double time, std::vector<Vec3>& forces);

/// A face on which a pressure acts [Pa].
struct PressedFace {
  std::array<NodeId, 3> nodes;
  double pressure = 0;
};
/// Per body, the faces under pressure at `time` [s].
std::vector<std::vector<PressedFace>> pressed_faces(const WorldState& world, double time);
/// Adds their forces to `forces` [N] with the nodes at `positions`; both per node of the mesh.
void add_pressure(std::span<const PressedFace> faces, std::span<const Vec3> positions, std::span<Vec3> forces);

}  // namespace griffith
