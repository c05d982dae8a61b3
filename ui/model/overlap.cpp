#include "ui/model/overlap.h"

#include <algorithm>
#include <limits>

#include "ui/model/units.h"

namespace griffith::ui {
namespace {

/// Fraction of the width from which an overlap counts as deep: bodies soon pass through each other.
constexpr double kDeep = 0.25;

/// Returns the extent of a body along a direction of the world [m]; infinite for a body without a shape.
double width_along(const BodyView& body, const Vec3& direction) {
  const Vec3 own = body.orientation.conjugate() * direction;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const std::vector<Vec3>& part : body.collision_parts)
    for (const Vec3& corner : part) {
      low = std::min(low, own.dot(corner));
      high = std::max(high, own.dot(corner));
    }
  return high >= low ? high - low : std::numeric_limits<double>::infinity();
}

}  // namespace

std::optional<DeepOverlap> deep_overlap(const Frame& frame) {
  DeepOverlap overlap{frame.report.max_penetration, std::numeric_limits<double>::infinity()};
  if (overlap.depth <= 0) return std::nullopt;
  for (const ContactView& contact : frame.contacts)
    for (const BodyId id : {contact.a, contact.b})
      if (id.valid()) overlap.width = std::min(overlap.width, width_along(frame.bodies[id], contact.normal));
  if (overlap.depth <= kDeep * overlap.width) return std::nullopt;
  return overlap;
}

std::string text_of(const DeepOverlap& overlap) {
  return "Bodies overlap by " + format_quantity(overlap.depth, "m", 3) + ", and the thinnest touching body is " +
         format_quantity(overlap.width, "m", 3) +
         " thick. Use a shorter time step, and separate bodies that overlap at the start (View > Problems).";
}

}  // namespace griffith::ui
