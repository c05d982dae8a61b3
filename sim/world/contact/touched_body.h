#pragma once

#include <span>
#include <vector>

#include "sim/contact/contact_world.h"
#include "sim/core/weighted_rows.h"
#include "sim/world/bodies/acting_bonds.h"
#include "sim/world/bodies/surface_point.h"

namespace griffith {

/// Point at which a contact touches an elastic body. While a gap closes, the contact lies off the surface of the
/// heavier. The torque of that offset acts on a free body as a whole, so that angular momentum is conserved.
struct TouchedPoint {
  SurfacePoint surface;
  NodeId node = {};              ///< node that touches, if known
  Vec3 contact = Vec3::Zero();   ///< [m]
  Vec3 position = Vec3::Zero();  ///< position of the surface point [m]
  /// Displacement of the surface point in the substep beside its velocity times the time, as the body turns [m].
  Vec3 turned = Vec3::Zero();
};

/// Elastic body with its contacts and bonds in a substep.
struct TouchedBody {
  BodyId body;
  std::vector<TouchedPoint> points;  ///< per contact of the object
  BondsOfBody bonds;                 ///< they act between points of the body itself
  std::vector<Vec3> bond_impulses;   ///< per pair, on its first node [N·s]
  NodeVectors free;    ///< velocities of the rows of its system without the contacts, once it has answered [m/s]
  NodeVectors change;  ///< change of their velocities by the contacts [m/s]
};

/// Elastic bodies with contacts or bonds, and the contact world's data of each, by body.
struct TouchedBodies {
  std::vector<TouchedBody> bodies;
  std::vector<ElasticObject> objects;
};

/// True for a contact of a node, which has its place.
inline bool is_of_nodes(const Contact& contact) { return contact.node_a.valid() || contact.node_b.valid(); }
/// True if contacts act at the surface of the first of two objects: at that of the lighter one. While a gap closes,
/// both are in different places, and the torque about a body of an impulse that is off its surface is one that it does
/// not get when they touch. A light plate would be flung up by it.
bool acts_on_first(const WorldState& world, ProxyId first, ProxyId second);
/// Returns a node as a point that touches at a place [m].
TouchedPoint touched_node(const WorldState& world, NodeId node, const Vec3& place);
/// Returns the point of a surface that touches at a place [m].
TouchedPoint touched_point(const WorldState& world, const SurfaceSearch& surface, const Vec3& place);

/// Lists what the contacts touch, and what bonds hold.
TouchedBodies touched_bodies(const WorldState& world);
/// Moves the contacts from the surfaces of the proxies, which do not deform, to those of the deformed bodies, and
/// corrects their distances; those of nodes are right.
void fit_contacts(const WorldState& world, TouchedBodies& touched, std::span<Contact> contacts);
/// Moves the contacts alone. Those at mean places of what turns far stay there.
void place_contacts(const WorldState& world, TouchedBodies& touched, std::span<Contact> contacts);
/// Returns the approach speed of the sides of each contact without its impulse, in a substep of `dt` [s] [m/s], for
/// ContactWorld::drop_near_misses().
std::vector<double> approach_speeds(const WorldState& world, const TouchedBodies& touched, double dt);
/// Sets TouchedPoint::turned of soft free bodies at their present velocities. Returns its largest change [m].
double foresee_turn(const WorldState& world, TouchedBody& touched, double dt);
/// Leaves out the contacts that the contact world has dropped. `index`: the new index of each, or -1.
void keep_contacts(TouchedBodies& touched, std::span<const int> index);
/// Returns the rows of its body's system that determine a point of the surface.
WeightedRows weighted_rows(const WorldState& world, const SurfacePoint& point);
/// Returns the velocities of the contact points for the present velocities of the body's nodes: J v.
Eigen::Matrix3Xd point_velocities(const WorldState& world, const TouchedBody& touched);
/// Adds the nodal impulses Jᵀ p of impulses p at the contact points to values per node of the mesh.
void add_nodal_impulses(const WorldState& world, const TouchedBody& touched, const Eigen::Matrix3Xd& impulses,
                        std::vector<Vec3>& nodal);

}  // namespace griffith
