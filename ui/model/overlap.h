#pragma once

#include <optional>
#include <string>

#include "sim/world/output/frame.h"

namespace griffith::ui {

/// Contacts with excessive penetration.
struct DeepOverlap {
  double depth = 0;  ///< penetration of the deepest contact [m]
  double width = 0;  ///< extent of the thinnest touching body along the normal of that contact [m]
};

/// Returns the deepest overlap; empty if it is small compared with the touching bodies.
std::optional<DeepOverlap> deep_overlap(const Frame& frame);

/// Explains the overlap and its remedy in two sentences.
std::string text_of(const DeepOverlap& overlap);

}  // namespace griffith::ui
