#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "sim/core/error.h"
#include "sim/mesh/tet_edges.h"
#include "sim/scene/boundary_condition.h"
#include "sim/scene/grab.h"
#include "sim/world/setup/rest_body.h"

namespace griffith {

struct WorldState;

/// Point of material on which a grab or a push acts.
struct MaterialPoint {
  TetId tet;           ///< tet with the point
  Vec3 weights;        ///< barycentric weights of its corners 1 to 3
  Vec3 rest_position;  ///< place in the undeformed body [m]
};

/// Spring of a grab, and the motion of its point in the last substep.
struct HeldSpring {
  Vec3 target;  ///< [m]
  GrabSpring constants;
  Vec3 position;    ///< [m]
  Vec3 velocity;    ///< mean [m/s]
  double time = 0;  ///< time of `position` [s]
};

/// Load and the place where it acts: one of the three lists, depending on its kind, or a point of material. The force
/// of a grab follows from its spring (grab_force.h).
struct PlacedLoad {
  Load load;
  std::vector<TetCorner> corners;  ///< one a node: the force stays with this piece of material
  std::vector<SurfaceFace> faces;  ///< faces of the unbroken surface
  std::vector<TetId> tets;
  std::optional<MaterialPoint> point = {};
  std::optional<HeldSpring> spring = {};  ///< present for a grab

  bool is_push() const { return point && !spring; }
};

/// Moment, or interval between two moments [s].
struct TimeSpan {
  double from = 0, to = 0;

  TimeSpan(double moment) : from(moment), to(moment) {}  // NOLINT(google-explicit-constructor)
  TimeSpan(double begin, double end) : from(begin), to(end) {}
  double duration() const { return to - from; }
};

/// Returns the fraction of a load that acts at a moment, or on average over a span: 0 before its start and after its
/// end, else up to 1. The mean is exact for loads of any duration, so a step of any length gives its impulse.
double load_factor(const Load& load, const TimeSpan& span);
/// True if the part that acts will change after `time` [s].
bool changes_after(const Load& load, double time);

/// Finds what a body's loads act on and appends them; one that acts on nothing becomes a finding.
void place_loads(const WorldState& world, int scene_body, const RestBody& body, std::vector<PlacedLoad>& all,
                 std::vector<InputError>& findings);

/// Makes rigid bodies elastic on which a load differs between `next` and `last`.
void make_loaded_bodies_elastic(WorldState& world, const TimeSpan& last, const TimeSpan& next);
/// Returns, by BodyId, whether loads strain a body at some time in `span`. A body force on a whole body strains
/// nothing.
std::vector<bool> strained_bodies(const WorldState& world, const TimeSpan& span);
/// Returns the bodies on which a load acts, ascending.
std::vector<BodyId> bodies_under(const WorldState& world, const PlacedLoad& placed);

/// External forces per node and per edge of the mesh [N].
struct ExternalForces {
  std::vector<Vec3> nodes, edges;
};

/// Adds the forces of all loads at a moment, or their means over a span, to `forces`. Their sums over nodes are exact:
/// a point force adds up to itself, a traction to itself times the undeformed area; a uniform pressure on a closed
/// surface has no resultant. A face's load goes in equal parts to its corners, which keeps its torque too. The edges of
/// a quadratic tet's face get a third of it each, ∫ 4 LᵢLⱼ dA: they work on the edges' offsets, and a bar in tension
/// has the same stress everywhere.
void add_load_forces(const WorldState& world, const TimeSpan& span, ExternalForces& forces);
/// Adds the forces of loads that do not depend on the positions: all but pressures.
void add_dead_forces(const WorldState& world, const TimeSpan& span, ExternalForces& forces);
/// Adds `factor` times the forces of one load where the nodes are now.
void add_load(const WorldState& world, const PlacedLoad& placed, double factor, ExternalForces& forces);
/// Returns no force on any node or edge.
ExternalForces no_forces(const WorldState& world);
/// Returns the weight of each node.
ExternalForces weights(const WorldState& world);

/// Face under pressure [Pa].
struct PressedFace {
  std::array<NodeId, 3> nodes;
  std::array<EdgeId, 3> edges;  ///< invalid ones of a linear tet
  double pressure = 0;
};
/// Returns, per body, the faces under pressure at a moment, or on average over a span.
std::vector<std::vector<PressedFace>> pressed_faces(const WorldState& world, const TimeSpan& span);
/// Adds their forces with the nodes at `positions`, per node and per edge of the mesh [N].
void add_pressure(std::span<const PressedFace> faces, std::span<const Vec3> positions, std::span<Vec3> forces,
                  std::span<Vec3> edge_forces);

}  // namespace griffith
