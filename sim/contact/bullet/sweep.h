#pragma once

// Private to sim/contact: distances and the first touch of moving shapes.

#include <optional>

#include "sim/contact/bullet/shapes.h"

namespace griffith::contact {

/// A shape in its place. The ground has no convex part: `convex` is null and it fills all below `ground_height`.
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

/// The shortest distance between two shapes, `a` a convex one.
Separation separation(const PlacedShape& a, const PlacedShape& b);

struct Touch {
  double fraction;  ///< of the displacement, 0..1
  Vec3 normal;      ///< unit, from the other shape to the moving one
};

/// How near to the origin a point comes that is displaced from `start` [m].
double nearest_distance(const Vec3& start, const Vec3& displacement);

/// Whether the boxes round two convex shapes come as near as `gap` [m] on the way: cheap, and no for most.
bool boxes_meet(const PlacedShape& moving, const Vec3& displacement, const PlacedShape& other, double gap);

/// Whether a displacement brings a shape nearer to one that lies against `normal`: more than rounding does.
bool comes_nearer(const Vec3& displacement, const Vec3& normal);

/// Where `moving`, displaced without turning, first is as near to `other` as `gap` [m] (negative: overlaps by that
/// much): at the start, if it is then, wherever it goes. Nothing if it does not come so near. Conservative advancement:
/// each move stays short of the plane that parts the shapes, so nothing is stepped over however thin it is.
std::optional<Touch> first_touch(PlacedShape moving, const Vec3& displacement, const PlacedShape& other, double gap);

}  // namespace griffith::contact
