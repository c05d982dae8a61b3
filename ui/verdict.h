#pragma once

#include <string>

#include "sim/world/node_report.h"

namespace griffith::ui {

/// Why a node broke, or did not, in a sentence or two.
struct Verdict {
  enum class Kind { holds, near, overloaded, broke, unknown };
  Kind kind = Kind::holds;
  std::string text;
};

/// `fracture`: whether the scene lets bodies break.
Verdict verdict_on(const NodeReport& report, const Frame& frame, bool fracture);

/// "Pa" or "N", what the load and resistance of a material are measured in.
const char* load_unit(const Material& material);
/// The load that is compared with the resistance [load_unit].
double load_of(const NodeSeparation& separation, const Material& material);

}  // namespace griffith::ui
