#pragma once

#include <span>
#include <vector>

#include "sim/contact/contact_world.h"
#include "sim/core/weighted_rows.h"
#include "sim/world/bodies/surface_point.h"

namespace griffith {

/// Where a contact touches an elastic body. While a gap closes, the contact lies half of it off the surface: a free
/// body takes the torque of that offset as a whole, so that angular momentum is kept.
struct TouchedPoint {
  SurfacePoint surface;
  NodeId node = {};              ///< where a node is known to touch
  Vec3 contact = Vec3::Zero();   ///< [m]
  Vec3 position = Vec3::Zero();  ///< position of the surface point [m]
};

/// An elastic body among its contacts in a substep.
struct TouchedBody {
  BodyId body;
  std::vector<TouchedPoint> points;  ///< per contact of the object
  NodeVectors free;    ///< velocities of the rows of its system without the contacts, once it has answered [m/s]
  NodeVectors change;  ///< what the contacts did to them [m/s]
};

/// Elastic bodies with contacts, and the contact world's data of each, by body.
struct TouchedBodies {
  std::vector<TouchedBody> bodies;
  std::vector<ElasticObject> objects;
};

/// Lists what the contacts touch.
TouchedBodies touched_bodies(const WorldState& world);
/// Moves the contacts from the surfaces of the proxies, which do not deform, to those of the deformed bodies, and
/// corrects their distances; those of nodes are right.
void fit_contacts(WorldState& world, TouchedBodies& touched);
/// Leaves out the contacts that will not push in a substep of `dt` [s]: here and in the contact world.
void drop_near_misses(WorldState& world, TouchedBodies& touched, double dt);
/// The rows of its body's system that carry a point of the surface.
WeightedRows weighted_rows(const WorldState& world, const SurfacePoint& point);
/// Velocities of the contact points as the body's nodes move now: J v.
Eigen::Matrix3Xd point_velocities(const WorldState& world, const TouchedBody& touched);
/// Nodal impulses Jᵀ p for impulses p at the contact points, added to values per node of the mesh.
void add_nodal_impulses(const WorldState& world, const TouchedBody& touched, const Eigen::Matrix3Xd& impulses,
                        std::vector<Vec3>& nodal);

}  // namespace griffith
