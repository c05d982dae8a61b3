#include "app/editor/symbol_picking.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace griffith::app {
namespace {

constexpr double kMissed = std::numeric_limits<double>::infinity();

/// Returns the distance along a ray at which it meets a disc with the normal `arm`, whose length is its radius.
double meet_disc(const Vec3& origin, const Vec3& direction, const Vec3& place, const Vec3& arm) {
  const double along = direction.dot(arm);
  if (along == 0) return kMissed;
  const double distance = (place - origin).dot(arm) / along;
  return distance > 0 && (origin + distance * direction - place).norm() <= arm.norm() ? distance : kMissed;
}

/// Returns the distance along a ray at which it passes a segment from place − arm to place + arm near enough.
double meet_segment(const Vec3& origin, const Vec3& direction, const Vec3& place, const Vec3& arm, double slack) {
  const Vec3 way = place - origin;
  const double along = direction.dot(arm), length = arm.squaredNorm(), across = length - along * along;
  const double at = across > 1e-12 * length ? (along * direction.dot(way) - arm.dot(way)) / across : 0;
  const Vec3 nearest = way + std::clamp(at, -1.0, 1.0) * arm;
  const double distance = direction.dot(nearest);
  return distance > 0 && (nearest - distance * direction).norm() <= slack * distance ? distance : kMissed;
}

}  // namespace

const LayerSymbol* symbol_on(const render::Ray& ray, std::span<const LayerSymbol> symbols, double slack, double limit) {
  const Vec3 origin = ray.origin.cast<double>(), direction = ray.direction.cast<double>();
  const LayerSymbol* nearest = nullptr;
  for (const LayerSymbol& symbol : symbols) {
    const double distance = symbol.symbol.kind == ui::SymbolKind::fracture_plane
                                ? meet_disc(origin, direction, symbol.place, symbol.arm)
                                : meet_segment(origin, direction, symbol.place, symbol.arm, slack);
    if (distance >= limit) continue;
    limit = distance;
    nearest = &symbol;
  }
  return nearest;
}

}  // namespace griffith::app
