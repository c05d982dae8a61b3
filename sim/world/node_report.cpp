#include "sim/world/node_report.h"

#include <algorithm>

namespace griffith {
namespace {

int corner_of(const Frame& frame, TetId tet, NodeId node) {
  const auto& corners = frame.tets[tet];
  return static_cast<int>(std::find(corners.begin(), corners.end(), node) - corners.begin());
}

double dyad_across(const Vec3& force, const Vec3& normal) { return normal.dot(force_dyad(force) * normal); }

ElementShare element_share(const Frame& frame, TetId tet, NodeId node, const Vec3& normal) {
  ElementShare element;
  element.tet = tet;
  Vec3 middle = Vec3::Zero();
  for (NodeId corner : frame.tets[tet]) middle += frame.positions[corner] / 4;
  element.above = normal.dot(middle - frame.positions[node]) > 0;
  element.force = split_force(frame.rests[tet], frame.states[tet], corner_of(frame, tet, node));
  element.share = 0.5 * (dyad_across(element.force.tensile, normal) - dyad_across(element.force.compressive, normal));
  return element;
}

}  // namespace

NodeReport node_report(const Frame& frame, NodeId node) {
  NodeReport report;
  report.node = node;
  report.body = frame.tet_bodies[frame.stars[node].front()];
  report.separation = frame.separations[node];
  report.principal = principal_values(report.separation.tensor);
  report.at_crack_front = frame.at_crack_front[node] != 0;
  report.supported = frame.node_held[node] != 0;
  const Vec3 normal = report.separation.direction;
  SplitForce total;
  for (TetId tet : frame.stars[node]) {
    report.elements.push_back(element_share(frame, tet, node, normal));
    total.tensile += report.elements.back().force.tensile;
    total.compressive += report.elements.back().force.compressive;
  }
  if (frame.constraints[node].is_free())
    report.balance = 0.5 * (dyad_across(total.compressive, normal) - dyad_across(total.tensile, normal));
  std::ranges::stable_sort(report.elements, std::greater(), &ElementShare::share);
  for (std::size_t i = 0; i < frame.crack_events.size(); ++i)
    if (frame.crack_events[i].rest_position == frame.rest_positions[node]) report.events.push_back(static_cast<int>(i));
  return report;
}

NodeId most_loaded_node(const Frame& frame) {
  NodeId best;
  for (std::size_t i = 0; i < frame.separations.size(); ++i) {
    if (frame.bodies[frame.tet_bodies[frame.stars[i].front()]].rigid) continue;
    if (!best.valid() || frame.separations[i].margin > frame.separations[best].margin)
      best = NodeId(static_cast<std::int64_t>(i));
  }
  return best;
}

}  // namespace griffith
