#pragma once

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "sim/contact/contact_world.h"
#include "sim/explicit/sharp_edge.h"
#include "sim/geometry/convex_hull.h"
#include "sim/geometry/half_space.h"

namespace griffith::explicit_dynamics {

/// Convex solid in its own frame [m].
struct ConvexSolid {
  std::vector<HalfSpace> faces;  ///< half-spaces whose intersection it is
  std::vector<Vec3> samples;     ///< corners, and points along the edges
  std::vector<SharpEdge> edges;

  /// Returns the largest distance of a point outside a face, and the normal of that face.
  std::pair<double, Vec3> outermost_face(const Vec3& local) const {
    double maximum = -std::numeric_limits<double>::infinity();
    Vec3 normal = Vec3::UnitY();
    for (const HalfSpace& face : faces) {
      const double distance = face.distance(local);
      if (distance > maximum) maximum = distance, normal = face.normal;
    }
    return {maximum, normal};
  }
};

/// `spacing`: largest distance of the points along the edges [m].
ConvexSolid convex_solid(const ConvexHull& hull, double spacing);

/// Rigid object that the bodies in explicit dynamics may hit: a projectile, a rigid piece, one that swings about a
/// pivot, what supports hold or drive, the ground.
struct Obstacle {
  ProxyId object;                   ///< object that it represents
  double radius = 0;                ///< radius of the sphere, or of the bounding sphere [m]; infinite for the ground
  std::vector<ConvexSolid> solids;  ///< empty: a sphere
  double inverse_mass = 0;          ///< 0: nothing changes the velocity of its own frame's origin [1/kg]
  Mat3 inverse_inertia = Mat3::Zero();  ///< in its own frame, about that origin [1/(kg·m²)]
  Vec3 center = Vec3::Zero();           ///< center of mass in its own frame; not zero if it swings about a pivot [m]
  RigidState state;
  double friction = 0.6;
  int family = -1;           ///< see SurfaceLaw; it does not touch bodies of its own family
  bool is_soft = false;      ///< deforms visibly: the ground does not stop all of it at once
  bool was_pushed = false;   ///< an impulse has changed its motion
  double energy_gained = 0;  ///< work of impulses at the mean of its velocities before and after [J]

  bool is_sphere() const { return solids.empty(); }
  bool is_movable() const { return inverse_mass > 0 || !inverse_inertia.isZero(0); }
  /// True if it is movable or driven.
  bool may_move() const { return is_movable() || !state.is_still(); }
  bool is_ground() const { return std::isinf(radius); }
  /// Returns the distance of a place from a solid of one face, the ground [m].
  double gap_of(const Vec3& place) const { return solids.front().faces.front().distance(state.pose.to_local(place)); }
  Vec3 velocity_at(const Vec3& place) const {
    return state.velocity + state.angular_velocity.cross(place - state.pose.translation);
  }
  void push(const Vec3& place, const Vec3& impulse);
  /// Moves and rotates it by the change of velocities of that impulse over `time` [s].
  void shift(const Vec3& place, const Vec3& impulse, double time);
  /// Returns the velocity change along a unit direction at a point by a unit impulse there [1/kg].
  double mobility(const Vec3& place, const Vec3& direction) const;
  /// Moves it by its velocity, including postponed time. To be called at least once before an impulse.
  void move(double dt);
  /// Postpones its motion.
  void wait(double dt) { waited_ += dt; }

 private:
  double waited_ = 0;                        ///< [s]
  Mat3 inverse_inertia_now_ = Mat3::Zero();  ///< inverse inertia in the world frame
};

}  // namespace griffith::explicit_dynamics
