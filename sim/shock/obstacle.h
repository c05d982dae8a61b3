#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "sim/contact/contact_world.h"
#include "sim/geometry/convex_hull.h"
#include "sim/geometry/half_space.h"

namespace griffith::shock {

/// A convex solid in its own frame [m].
struct ConvexSolid {
  std::vector<HalfSpace> faces;  ///< it is what they have in common
  std::vector<Vec3> samples;     ///< corners, and points along the edges

  /// How far a point is outside, at most, and the normal of the face across which.
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

/// `spacing`: of the points along the edges, at most [m].
ConvexSolid convex_solid(const ConvexHull& hull, double spacing);

/// Something rigid that the bodies of a shock run into: a projectile, a piece that keeps its shape, the ground.
struct Obstacle {
  ProxyId object;                   ///< what it stands for
  double radius = 0;                ///< of the sphere that it is, or of the one round it [m]; infinite for the ground
  std::vector<ConvexSolid> solids;  ///< none: a sphere
  double inverse_mass = 0;          ///< 0: nothing moves it [1/kg]
  Mat3 inverse_inertia = Mat3::Zero();  ///< in its own frame
  RigidState state;
  double friction = 0.6;
  double energy_gained = 0;  ///< by pushes: their work at the mean of its velocities before and after [J]

  bool is_sphere() const { return solids.empty(); }
  Vec3 velocity_at(const Vec3& place) const {
    return state.velocity + state.angular_velocity.cross(place - state.pose.translation);
  }
  void push(const Vec3& place, const Vec3& impulse);
  /// Moves and turns it as far as the change of velocities by that impulse would in `time` [s].
  void shift(const Vec3& place, const Vec3& impulse, double time);
  /// The velocity change along a unit direction at a place by a unit impulse there [1/kg].
  double mobility(const Vec3& place, const Vec3& direction) const;
  /// Moves it by its velocity, for what it has waited as well: once at least, before it is pushed.
  void move(double dt);
  /// Moves it later.
  void wait(double dt) { waited_ += dt; }

 private:
  double waited_ = 0;                        ///< [s]
  Mat3 inverse_inertia_now_ = Mat3::Zero();  ///< in the world frame
};

}  // namespace griffith::shock
