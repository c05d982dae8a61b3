#include "app/editor/breakpoints.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "ui/model/units.h"

namespace griffith::app {
namespace {

using ui::Breakpoints;
using ui::Stop;

std::string node_text(NodeId node) { return "Node " + std::to_string(node.index()); }

bool concerns(const CrackEvent& event, const Breakpoints& breakpoints, const Frame& after, int scene_body,
              const ui::Selection& selection) {
  switch (breakpoints.crack) {
    case Breakpoints::Where::nowhere:
      return false;
    case Breakpoints::Where::anywhere:
      return true;
    case Breakpoints::Where::body:
      return after.bodies[event.body].scene_body == scene_body;
    case Breakpoints::Where::node:
      return selection.valid() && event.rest_position == selection.rest_position;
  }
  return false;
}

bool is_known(NodeId node, const Frame& frame) {
  return static_cast<std::size_t>(node.index()) < frame.nodes.positions.size();
}

std::optional<Stop> next_crack(const Breakpoints& breakpoints, const Frame& before, const Frame& after, int scene_body,
                               const ui::Selection& selection) {
  for (std::size_t i = before.crack_events.size(); i < after.crack_events.size(); ++i)
    if (concerns(after.crack_events[i], breakpoints, after, scene_body, selection)) {
      // A node made by an earlier crack of this step does not exist before it.
      const CrackEvent& event = after.crack_events[i];
      return Stop{node_text(event.node) + " cracks in the next step, at " +
                      ui::format_quantity(100 * event.load / event.resistance, "", 3) + " % of its resistance.",
                  is_known(event.node, before) ? event.node : NodeId(),
                  {}};
    }
  return {};
}

/// Returns the eigenvalues of the separation tensor of the forces at a crack, largest first [N] (O'Brien & Hodgins
/// 1999, eq. 16). `constrained`: a support acts on the node, whose reaction is missing from the sums of forces.
Vec3 eigenvalues_at(const CrackEvent& event, bool constrained) {
  Mat3 tensor = Mat3::Zero();
  SplitForce sum;
  for (const CrackElement& element : event.elements) {
    tensor += (force_dyad(element.force.tensile) - force_dyad(element.force.compressive)) / 2;
    sum.tensile += element.force.tensile;
    sum.compressive += element.force.compressive;
  }
  if (!constrained) tensor += (force_dyad(sum.compressive) - force_dyad(sum.tensile)) / 2;
  return Eigen::SelfAdjointEigenSolver<Mat3>(tensor, Eigen::EigenvaluesOnly).eigenvalues().reverse();
}

ui::ComingCrack coming_crack(const CrackEvent& event, const Frame& before) {
  const bool constrained = !before.nodes.constraints[event.node].is_free();
  return {event.node, event.time, event.load, event.resistance, event.normal, eigenvalues_at(event, constrained)};
}

/// Returns the first crack of the step at each node that exists before it.
std::vector<ui::ComingCrack> coming_cracks(const Frame& before, const Frame& after) {
  std::vector<ui::ComingCrack> cracks;
  for (const CrackEvent& event : after.crack_events.subspan(before.crack_events.size()))
    if (is_known(event.node, before) && std::ranges::find(cracks, event.node, &ui::ComingCrack::node) == cracks.end())
      cracks.push_back(coming_crack(event, before));
  return cracks;
}

std::optional<Stop> passed_limit(const Breakpoints& breakpoints, const Frame& before, const Frame& after) {
  if (breakpoints.on_utilization && after.report.peak_utilization > breakpoints.utilization &&
      before.report.peak_utilization <= breakpoints.utilization)
    return Stop{"The utilization of a node reaches " + ui::format_quantity(after.report.peak_utilization, "", 3) +
                    " in the next step.",
                {},
                {}};
  if (breakpoints.on_pieces && after.fragments >= breakpoints.pieces && before.fragments < breakpoints.pieces)
    return Stop{"There are " + std::to_string(after.fragments) + " pieces after the next step.", {}, {}};
  const double turned_over = after.energy_of_step.turned_over();
  const double unaccounted = std::abs(after.energy_of_step.unaccounted());
  if (breakpoints.on_energy && unaccounted > breakpoints.energy * turned_over && unaccounted > 0)
    return Stop{"The next step leaves " + ui::format_quantity(100 * unaccounted / turned_over, "", 3) +
                    " % of its energy turnover unaccounted for.",
                {},
                {}};
  if (breakpoints.on_failure && (after.report.unconverged_solves > 0 || after.report.non_finite_values > 0))
    return Stop{"In the next step a solve does not converge or values are not finite.", {}, {}};
  return {};
}

}  // namespace

std::optional<ui::Stop> met_breakpoint(const ui::Breakpoints& breakpoints, const Frame& before, const Frame& after,
                                       int scene_body, const ui::Selection& selection) {
  std::optional<Stop> stop = next_crack(breakpoints, before, after, scene_body, selection);
  if (!stop) stop = passed_limit(breakpoints, before, after);
  if (stop) stop->cracks = coming_cracks(before, after);
  return stop;
}

}  // namespace griffith::app
