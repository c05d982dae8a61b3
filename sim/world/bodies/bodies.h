#pragma once

#include <optional>
#include <span>
#include <vector>

#include "sim/elasticity/placement.h"
#include "sim/world/state/world_state.h"

namespace griffith {

/// Returns the body of a node.
inline const Body& body_at(const WorldState& world, NodeId node) {
  return world.bodies[world.elements.bodies[world.mesh->stars[node].front()]];
}

/// Takes the stress out of a body that is rigid from now on.
void clear_stress(const Body& body, ElementArrays& elements, NodeArrays& nodes);
/// Divides the tets of bodies that may have separated among one body per piece that faces or bonds connect, then calls
/// rebuild_pieces(). Returns all pieces: first the bodies themselves, then the new ones.
std::vector<BodyId> part_bodies(WorldState& world, std::span<const BodyId> opened);
/// Rebuilds all data that follow from the tets of pieces; new ones, which are the last bodies, get their proxies.
void rebuild_pieces(WorldState& world, std::span<const BodyId> pieces);
/// Assigns a body to each known piece: one continues as the body itself, each other becomes a new body, of which only
/// the tets are set.
void assign_pieces(WorldState& world, BodyId id, std::vector<std::vector<TetId>> pieces);
/// Rebuilds all data that follow from the tets of a body with a proxy: those of rebuild_shape(), collision parts and
/// proxy.
void rebuild_body(WorldState& world, Body& body);
/// Returns the volume of a body over its surface at rest, without faces beyond which it goes on [m].
double depth_of(const WorldState& world, const Body& body);
/// Rebuilds nodes, surface, system and motion of a body. Writes only data of the body. Returns the energy that it lost
/// if it becomes rigid [J].
double rebuild_shape(WorldState& world, Body& body);
/// Returns the state of a body's proxy. What is held stands still for others, however it vibrates.
RigidState proxy_state(const WorldState& world, const Body& body);
/// Fits the proxy of a body that becomes rigid or falls asleep to its deformed shape.
void fit_proxy(WorldState& world, Body& body);
/// Fits the proxy of a deformable body to its shape if the two differ visibly. The body keeps its orientation.
void follow_deformation(WorldState& world, Body& body);
/// Makes the proxies of bodies that have none yet out of their collision parts, in the contact world.
void add_proxies(WorldState& world, std::span<Body> bodies);
/// Returns the rigid motion with the momentum of a body's nodes.
RigidMotion motion_of(const WorldState& world, const Body& body);
/// Returns that of some nodes, which must not all lie on one line.
RigidMotion motion_of(const WorldState& world, const std::vector<NodeId>& nodes);
/// Takes mass, momentum and orientation of a body from its nodes.
void update_motion(const WorldState& world, Body& body);
/// Returns the placement that fits nodes best, weighted by their masses.
Placement placement_of(const WorldState& world, std::span<const NodeId> nodes);
/// Returns the least stress, over the face of an element, that could open a crack in the body or extend one [Pa].
double min_breaking_stress(const WorldState& world, const Body& body, bool at_crack_front);
/// Returns the stress that strains a body visibly, by a thousandth [Pa]; infinite for debris of up to 20 tets.
double visible_stress(const WorldState& world, const Body& body);
/// Distance from its shape by which a node is off before contacts may be found on the wrong side of a thin body, an
/// eighth of its thickness [m].
double bending_tolerance(const Body& body);
/// Distance from its shape by which a node of a rigid body may be off [m].
double shape_tolerance(const Body& body);
/// True if a body is a plate or a beam, of at most a tenth of its extent: it bends more than it shears.
bool is_thin(const Body& body);
/// Returns the stress at the surface of a body that a force [N] in its middle bends between its ends [Pa]: that of a
/// beam, 3/2 F l/(b t²) with its extent l, its thickness t, twice its depth, and the breadth b that its volume leaves.
double bending_stress(const WorldState& world, const Body& body, double force);
/// Returns the bending stress at which the deflection σ l²/(6 E t) is five thousandths of the extent of what a body is
/// a piece of [Pa]; infinite for debris.
double visible_bending_stress(const WorldState& world, const Body& body);
/// True if a body is visibly strained before it breaks.
bool deforms_visibly(const WorldState& world, const Body& body);
/// True if a tet of a body is strained by more than `strain` [-], about, by its energy.
bool is_strained_by(const WorldState& world, const Body& body, double strain);
/// True if a body that deforms visibly does so now.
bool is_visibly_strained(const WorldState& world, const Body& body);
/// True if a body is visibly strained by its own weight wherever it lies.
bool sags_visibly(const WorldState& world, const Body& body);
/// Returns the least speed of an impact that could cause damage [m/s]; infinite for a single tet, which cannot break.
double damage_speed(const WorldState& world, const Body& body);
/// Returns the node speed at which waves approach visible_stress(), or bending moves nodes of a thin body by 3·10⁻⁴ of
/// its extent at its lowest frequency, π² c t/(√12 l²) of a beam [m/s]; infinite for debris.
double visible_speed(const WorldState& world, const Body& body);
/// True if all nodes of a body move slower than `speed` [m/s] relative to a motion of the whole.
bool all_slower(const WorldState& world, const Body& body, const RigidMotion& whole, double speed);

/// Adds the velocities that a spin [rad/s] of the whole body gives its edges.
void add_spin_to_edges(const Body& body, const Vec3& spin, EdgeArrays& edges);
/// Adds the spin that restores the angular momentum of a body's motion `before`; `now`: its present motion.
void restore_spin(WorldState& world, const Body& body, const RigidMotion& before, const RigidMotion& now);

}  // namespace griffith
