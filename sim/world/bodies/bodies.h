#pragma once

#include <optional>
#include <span>
#include <vector>

#include "sim/elasticity/placement.h"
#include "sim/solver/pivot.h"
#include "sim/world/world_state.h"

namespace griffith {

/// The body that a node belongs to.
inline const Body& body_at(const WorldState& world, NodeId node) {
  return world.bodies[world.elements.bodies[world.mesh->stars[node].front()]];
}

/// Takes the stress out of a body that is rigid from now on.
void clear_stress(WorldState& world, const Body& body);
/// Gives the tets of bodies that may have come apart to one body for each connected piece; then rebuild_pieces().
/// Returns all pieces: first the bodies themselves, then the new ones.
std::vector<BodyId> part_bodies(WorldState& world, std::span<const BodyId> opened);
/// Rebuilds what follows from the tets of pieces; new ones, the last bodies, get their proxies.
void rebuild_pieces(WorldState& world, std::span<const BodyId> pieces);
/// Gives each piece that is known a body: one goes on as the body itself, each other becomes a new body, of which
/// nothing but the tets is known yet.
void assign_pieces(WorldState& world, BodyId id, std::vector<std::vector<TetId>> pieces);
/// Rebuilds what follows from the tets of a body with a proxy: all that rebuild_shape() does, collision parts and
/// proxy.
void rebuild_body(WorldState& world, Body& body);
/// Nodes, surface, system and motion of a body. Writes to what is the body's own alone. Returns the energy that it lost
/// where it is rigid from now on [J].
double rebuild_shape(WorldState& world, Body& body);
/// Gives the proxy of a body that is rigid or asleep from now on the shape to which it has deformed.
void fit_proxy(WorldState& world, Body& body);
/// Gives the proxy of a body that goes on deforming the shape that it has, where the two differ visibly. The body keeps
/// its orientation.
void follow_deformation(WorldState& world, Body& body);
/// Makes the proxies of bodies that have none yet out of their collision parts, in the contact world.
void add_proxies(WorldState& world, std::span<Body> bodies);
/// The rigid motion that carries the momentum of a body's nodes.
RigidMotion motion_of(const WorldState& world, const Body& body);
/// Returns the place and axes about which its supports let a body turn, none where they hold it more firmly.
std::optional<Pivot> pivot_of(const WorldState& world, const Body& body);
/// Takes mass, momentum and orientation of a body from its nodes.
void update_motion(WorldState& world, Body& body);
/// The placement that fits nodes best, by their masses.
Placement placement_of(const WorldState& world, std::span<const NodeId> nodes);
/// The least stress, spread over the face of an element, that could open a crack somewhere in the body, or could let
/// one run on that is there already [Pa].
double min_breaking_stress(const WorldState& world, const Body& body, bool at_crack_front);
/// Stress that strains a body visibly, by a thousandth [Pa]; infinite for debris of up to 20 tets.
double visible_stress(const WorldState& world, const Body& body);
/// True if a body is visibly strained before it breaks.
bool deforms_visibly(const WorldState& world, const Body& body);
/// True if a tet of a body is strained by more than `strain` [-], about, by its energy.
bool is_strained_by(const WorldState& world, const Body& body, double strain);
/// True if a body that deforms visibly does so now.
bool is_visibly_strained(const WorldState& world, const Body& body);
/// True if a body is visibly strained by its own weight wherever it lies.
bool sags_visibly(const WorldState& world, const Body& body);
/// The speed of an impact from which a body could be hurt [m/s]; infinite for a single tet, which cannot break.
double damage_speed(const WorldState& world, const Body& body);
/// Speed of nodes from which waves come near visible_stress() [m/s].
double visible_speed(const WorldState& world, const Body& body);
/// The same for impacts that have to be judged: more in a body of one cell, without cracks, where no wave comes back as
/// tension before it has spread. Of 2,500 random ones none broke below 2.2 σ_t/(ρc); finer ones do from 0.77 on [m/s].
double harmful_impact_speed(const WorldState& world, const Body& body);

}  // namespace griffith
