#include "sim/world/output/node_report.h"

#include <algorithm>
#include <functional>
#include <optional>

#include "sim/fracture/fracture_law.h"

namespace griffith {
namespace {

double dyad_across(const Vec3& force, const Vec3& normal) { return normal.dot(force_dyad(force) * normal); }

ElementContribution contribution_of(const Frame& frame, const SeparationInput& input, TetId tet,
                                    const NodeReport& report) {
  const Vec3 normal = report.normal();
  ElementContribution element;
  element.tet = tet;
  Vec3 middle = Vec3::Zero();
  for (NodeId corner : frame.elements.tets[tet]) middle += frame.nodes.positions[corner] / 4;
  element.above = normal.dot(middle - frame.nodes.positions[report.node]) > 0;
  element.force = split_force(input, tet, report.node);
  element.contribution =
      report.by_tension
          ? tension_fraction(input, tet, report.node, report.plane)
          : 0.5 * (dyad_across(element.force.tensile, normal) - dyad_across(element.force.compressive, normal));
  return element;
}

/// Returns the contribution of the sums of all forces to v⁺ [N].
double balance_of(const NodeReport& report) {
  SplitForce total;
  for (const ElementContribution& element : report.elements) {
    total.tensile += element.force.tensile;
    total.compressive += element.force.compressive;
  }
  return 0.5 * (dyad_across(total.compressive, report.normal()) - dyad_across(total.tensile, report.normal()));
}

/// Fills in what the frame's stresses do to the node.
void strain(const Frame& frame, NodeReport& report) {
  const SeparationInput input{
      frame.elements.tets,     frame.nodes.stars,    frame.elements.rest_elements,   frame.elements.states,
      frame.nodes.constraints, frame.elements.edges, frame.elements.quadratic_states};
  const int scene_body = frame.bodies[report.body].scene_body;
  const std::optional<Weakness>& weakness = frame.weaknesses[scene_body];
  const Mat3 tensor = separation_tensor(input, report.node);
  report.strained = true;
  report.principal = principal_values(tensor);
  report.plane = candidate_plane(input, report.node, tensor,
                                 weakness ? strength_at(input, report.node, *weakness) : DirectionalStrength());
  const Material& material = frame.materials[scene_body];
  const FractureLaw& law = fracture_law(material);
  report.by_tension = law.is_stress() && report.plane.by_tension;
  report.load = law.load(input, report.node, material, report.plane);
  for (TetId tet : frame.nodes.stars[report.node])
    report.elements.push_back(contribution_of(frame, input, tet, report));
  if (!report.by_tension && frame.nodes.constraints[report.node].is_free()) report.balance = balance_of(report);
  std::ranges::stable_sort(report.elements, std::greater(), &ElementContribution::contribution);
}

}  // namespace

NodeReport node_report(const Frame& frame, NodeId node) {
  NodeReport report;
  report.node = node;
  report.body = frame.elements.bodies[frame.nodes.stars[node].front()];
  report.separation = frame.nodes.separations[node];
  report.at_crack_front = frame.nodes.at_crack_front[node] != 0;
  report.supported = frame.nodes.has_support[node] != 0;
  if (!frame.bodies[report.body].rigid) strain(frame, report);
  for (std::size_t i = 0; i < frame.crack_events.size(); ++i)
    if (frame.crack_events[i].rest_position == frame.nodes.rest_positions[node])
      report.events.push_back(static_cast<int>(i));
  return report;
}

NodeId most_loaded_node(const Frame& frame) {
  NodeId best;
  for (std::size_t i = 0; i < frame.nodes.separations.size(); ++i) {
    if (frame.bodies[frame.elements.bodies[frame.nodes.stars[i].front()]].rigid) continue;
    if (!best.valid() || frame.nodes.separations[i].utilization > frame.nodes.separations[best].utilization)
      best = NodeId(static_cast<std::int64_t>(i));
  }
  return best;
}

}  // namespace griffith
