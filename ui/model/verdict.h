#pragma once

#include <optional>
#include <string>

#include "sim/world/output/node_report.h"
#include "ui/model/stop.h"

namespace griffith::ui {

/// Text if no node can be the most loaded one.
inline constexpr char kNothingStrained[] =
    "all pieces move as rigid bodies. Their stress stays as it was until something hits them.";

/// Returns the step that opened a crack as the timeline counts it: the number of the resulting state.
inline std::int64_t step_of(const CrackEvent& crack) { return crack.step + 1; }

/// State of a node as shown; every sentence about the node follows from it.
struct NodeState {
  /// Known load on the existing material.
  enum class Load { unmeasured, none, below, near, above };
  /// Motion of the node's piece.
  enum class Piece { elastic, asleep, rigid, rigid_asleep, single_element };

  Load load = Load::unmeasured;
  Piece piece = Piece::elastic;
  const CrackEvent* crack = nullptr;  ///< last crack at the node; null: never cracked
  bool cracked_now = false;           ///< that crack opened in the step that led to this state
  std::optional<ComingCrack> coming;  ///< crack of the next step, or later in a step that has begun
};

/// Returns the crack that is still to come at a node. `stop`: as for node_state().
std::optional<ComingCrack> coming_crack(const std::optional<Stop>& stop, NodeId node, const Frame& frame);

/// Returns the state of a node. `stop`: reason why the simulation stopped in this state, which predicts the next
/// cracks.
NodeState node_state(const NodeReport& report, const Frame& frame, const std::optional<Stop>& stop);

/// Explanation why a node broke or holds, in a sentence or two.
struct Verdict {
  enum class Kind { holds, near, overloaded, broke, unknown, about_to_crack };
  Kind kind = Kind::holds;
  std::string text;
};

/// Returns the verdict on a node. `fracture`: the scene lets bodies break. `stop`: as for node_state(). `in_step`: the
/// frame is a microstep of the step that the stop is about.
Verdict verdict_on(const NodeReport& report, const Frame& frame, bool fracture,
                   const std::optional<Stop>& stop = std::nullopt, bool in_step = false);

/// Describes the stand-in material of a scaled impact and its reason: "As a material of 273 MPa ...".
std::string stand_in_text(const ScaledImpact& impact);

/// Returns the load that is compared with the resistance [FractureLaw::unit].
double load_of(const NodeSeparation& separation, const Material& material);
/// Formats the resistance: "60 kPa", or that it is not known yet.
std::string resistance_text(const NodeSeparation& separation, const Material& material);

/// Returns the unit of the shares of the report's elements: "N" or "Pa".
const char* contribution_unit(const NodeReport& report);
/// Describes the origin of the load at the frame's time: "2.35 kN over 0.1 m²", "the mean tensile stress of its
/// elements".
std::string origin_of_load(const NodeReport& report, const Material& material);

}  // namespace griffith::ui
