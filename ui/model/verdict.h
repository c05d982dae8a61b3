#pragma once

#include <string>

#include "sim/world/node_report.h"

namespace griffith::ui {

/// Why no node can be the most loaded one.
inline constexpr char kNothingStrained[] =
    "all pieces move as rigid bodies. What little stress they were left with stays as it is until something strikes "
    "them.";

/// Why a node broke, or did not, in a sentence or two.
struct Verdict {
  enum class Kind { holds, near, overloaded, broke, unknown };
  Kind kind = Kind::holds;
  std::string text;
};

/// `fracture`: whether the scene lets bodies break.
Verdict verdict_on(const NodeReport& report, const Frame& frame, bool fracture);

/// What stood in for the material of what broke while it was scaled, and why: "As a material of 273 MPa ...".
std::string stand_in_text(const ScaledImpact& impact);

/// "Pa" or "N", what the load and resistance of a material are measured in.
const char* load_unit(const Material& material);
/// The load that is compared with the resistance [load_unit].
double load_of(const NodeSeparation& separation, const Material& material);
/// "60 kPa", or that it is not known yet.
std::string resistance_text(const NodeSeparation& separation, const Material& material);

/// "N" or "Pa", what the shares of the report's elements are measured in.
const char* contribution_unit(const NodeReport& report);
/// What the load at the frame's time comes from: "2.35 kN over 0.1 m²", "the mean tensile stress of its elements".
std::string origin_of_load(const NodeReport& report, const Material& material);

}  // namespace griffith::ui
