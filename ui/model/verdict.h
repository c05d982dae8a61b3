#pragma once

#include <optional>
#include <string>

#include "sim/world/node_report.h"
#include "ui/model/stop.h"

namespace griffith::ui {

/// Why no node can be the most loaded one.
inline constexpr char kNothingStrained[] =
    "all pieces move as rigid bodies. What little stress they were left with stays as it is until something strikes "
    "them.";

/// The step that opened a crack, as the bar of time counts: the number of the state that it led to.
inline std::int64_t step_of(const CrackEvent& crack) { return crack.step + 1; }

/// How a node stands in the state that is shown: the one value from which every sentence about it follows.
struct NodeState {
  /// What is known of the load on what is there now.
  enum class Load { unmeasured, none, below, near, above };
  /// How its piece moves.
  enum class Piece { elastic, asleep, rigid, rigid_asleep, single_element };

  Load load = Load::unmeasured;
  Piece piece = Piece::elastic;
  const CrackEvent* crack = nullptr;  ///< the last at the node; null: it never cracked
  bool cracked_now = false;           ///< that was in the step that led to this state
  std::optional<ComingCrack> coming;  ///< the next step cracks it
};

/// `stop`: why the simulation stopped in this state, if it did: it knows what the next step cracks.
NodeState node_state(const NodeReport& report, const Frame& frame, const std::optional<Stop>& stop);

/// Why a node broke, or did not, in a sentence or two.
struct Verdict {
  enum class Kind { holds, near, overloaded, broke, unknown, about_to_crack };
  Kind kind = Kind::holds;
  std::string text;
};

/// `fracture`: whether the scene lets bodies break. `stop`: as node_state() has it.
Verdict verdict_on(const NodeReport& report, const Frame& frame, bool fracture,
                   const std::optional<Stop>& stop = std::nullopt);

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
