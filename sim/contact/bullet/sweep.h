#pragma once

// Private to sim/contact: distances and the first touch of moving shapes.

#include <optional>

#include "sim/contact/bullet/shapes.h"

namespace griffith::contact {

/// Shape at its place. The ground has no convex part: `convex` is null, and it fills everything below `ground_height`.
struct PlacedShape {
  const btConvexShape* convex = nullptr;
  btTransform transform = btTransform::getIdentity();
  double ground_height = 0;
};

struct Separation {
  double distance;  ///< negative when overlapping [m]
  Vec3 normal;      ///< unit, from b to a
  Vec3 point_on_b;  ///< [m]
};

/// Returns the shortest distance between two shapes, `a` a convex one; between corners at most that.
Separation separation(const PlacedShape& a, const PlacedShape& b);

struct Touch {
  double fraction;  ///< fraction of the displacement, 0..1
  Vec3 normal;      ///< unit, from the other shape to the moving one
};

/// Returns the smallest distance to the origin of a point that is displaced from `start` [m].
double nearest_distance(const Vec3& start, const Vec3& displacement);

/// True if the boxes around two convex shapes come within `gap` [m] of each other on the way: cheap, and false for
/// most.
bool boxes_meet(const PlacedShape& moving, const Vec3& displacement, const PlacedShape& other, double gap);

/// True if a displacement moves a shape toward another one that lies against `normal`, by more than rounding errors.
bool comes_nearer(const Vec3& displacement, const Vec3& normal);

/// Returns the first touch of `moving`, displaced without rotation, at a distance of `gap` [m] (negative: overlap) to
/// `other`; at the start if it is closer there. Empty if it stays farther away. Conservative advancement: each move
/// ends before the plane that separates the shapes, so thin objects are never passed.
std::optional<Touch> first_touch(PlacedShape moving, const Vec3& displacement, const PlacedShape& other, double gap);

}  // namespace griffith::contact
