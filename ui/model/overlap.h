#pragma once

#include <optional>
#include <string>

#include "sim/world/frame.h"

namespace griffith::ui {

/// Contacts in which things pass into one another further than they should.
struct DeepOverlap {
  double depth = 0;  ///< of the deepest contact [m]
  double width = 0;  ///< of the thinnest body that touches something, along the normal of that contact [m]
};

/// Nothing where the deepest overlap is small beside what touches.
std::optional<DeepOverlap> deep_overlap(const Frame& frame);

/// What it means and what to do, in two sentences.
std::string text_of(const DeepOverlap& overlap);

}  // namespace griffith::ui
