#include "sim/world/conditions/probes.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <limits>
#include <set>

#include "sim/core/error.h"
#include "sim/elasticity/principal_stress.h"
#include "sim/geometry/closest_on_triangle.h"
#include "sim/scene/field.h"
#include "sim/world/bodies/surface_point.h"
#include "sim/world/world_state.h"

namespace griffith {
namespace {

// --- Where a probe measures -----------------------------------------------------------------------------------------

using TetPoints = std::array<Vec3, 4>;

TetPoints points_of(const TetSoup& soup, std::size_t tet) {
  TetPoints points;
  for (int i = 0; i < 4; ++i) points[i] = soup.points[soup.tets[tet][i]];
  return points;
}

Eigen::Vector4d barycentric_weights(const TetPoints& points, const Vec3& position) {
  Mat3 edges;
  for (int i = 0; i < 3; ++i) edges.col(i) = points[i + 1] - points[0];
  const Vec3 weights = edges.inverse() * (position - points[0]);
  return {1 - weights.sum(), weights.x(), weights.y(), weights.z()};
}

/// Returns the weights of the tet's point closest to `position`, and its distance.
std::pair<Eigen::Vector4d, double> closest_on_tet(const TetPoints& points, const Vec3& position) {
  const Eigen::Vector4d inside = barycentric_weights(points, position);
  if (inside.minCoeff() >= 0) return {inside, 0};
  std::pair<Eigen::Vector4d, double> best{inside, std::numeric_limits<double>::infinity()};
  for (const std::array<int, 3>& face : kTetFaces) {
    const std::array<Vec3, 3> corners = {points[face[0]], points[face[1]], points[face[2]]};
    const Vec3 on_face = closest_on_triangle(position, corners);
    Eigen::Vector4d weights = Eigen::Vector4d::Zero();
    Vec3 closest = Vec3::Zero();
    for (int i = 0; i < 3; ++i) weights[face[i]] = on_face[i], closest += on_face[i] * corners[i];
    if (const double distance = (closest - position).norm(); distance < best.second) best = {weights, distance};
  }
  return best;
}

ProbedNode probed_node(const RestBody& body, int node, double weight) {
  std::vector<std::uint8_t> marked(body.soup.points.size(), 0);
  marked[node] = 1;
  std::vector<TetCorner> star = corners_at(body, marked);
  return {star.front(), weight, std::move(star)};
}

std::vector<ProbedNode> nodes_at(const RestBody& body, const ProbePoint& place) {
  std::pair<Eigen::Vector4d, double> best{Eigen::Vector4d::Zero(), std::numeric_limits<double>::infinity()};
  std::size_t best_tet = 0;
  for (std::size_t tet = 0; tet < body.soup.tets.size(); ++tet) {
    const auto found = closest_on_tet(points_of(body.soup, tet), place.point);
    if (found.second < best.second) best = found, best_tet = tet;
  }
  std::vector<ProbedNode> nodes;
  for (int i = 0; i < 4; ++i) {
    nodes.push_back(probed_node(body, body.soup.tets[best_tet][i], best.first[i]));
    nodes.back().corner = {TetId(static_cast<std::int64_t>(best_tet)).shifted(body.range.first_tet), i};
  }
  return nodes;
}

std::vector<ProbedNode> nodes_at(const RestBody& body, const ProbeNode& place) {
  const auto node = std::ranges::find(body.point_of_node, place.node);
  if (node == body.point_of_node.end()) return {};
  return {probed_node(body, static_cast<int>(node - body.point_of_node.begin()), 1)};
}

std::vector<ProbedNode> nodes_at(const RestBody& body, const Region& region) {
  const std::vector<std::uint8_t> marked = nodes_in(body, region);
  const double weight = 1.0 / static_cast<double>(std::max<std::ptrdiff_t>(1, std::ranges::count(marked, 1)));
  std::vector<int> index(marked.size(), -1);
  std::vector<ProbedNode> nodes;
  for (const TetCorner& corner : corners_at(body, marked)) {
    int& i = index[soup_node(body, corner)];
    if (i < 0) {
      i = static_cast<int>(nodes.size());
      nodes.push_back({corner, weight, {}});
    }
    nodes[i].star.push_back(corner);
  }
  return nodes;
}

std::string place_of(std::size_t probe, const char* field) { return "#/probes/" + std::to_string(probe) + "/" + field; }

// --- What it measures -----------------------------------------------------------------------------------------------

/// Means over a probe's nodes; `reaction` is a sum.
struct Sample {
  Vec3 displacement = Vec3::Zero(), velocity = Vec3::Zero(), reaction = Vec3::Zero();
  Mat3 stress = Mat3::Zero();
  double utilization = 0, separation_stress = 0, eigenvalue = 0;
};

/// Returns the Cauchy stress of a tet at one of its corners [Pa].
Mat3 corner_stress(const Frame& frame, const TetCorner& corner) {
  const bool is_quadratic = !frame.elements.edges.empty() && frame.elements.edges[corner.tet][0].valid();
  if (!is_quadratic) return frame.elements.stresses[corner.tet];
  const ElementState& state = frame.elements.quadratic_states[corner.tet].corners[corner.corner];
  return cauchy_stress(state.frame, state.stress);
}

Mat3 stress_at(const ProbedNode& probed, NodeId node, const Frame& frame) {
  Mat3 sum = Mat3::Zero();
  double volume = 0;
  for (const TetCorner& corner : probed.star) {
    if (node_at(frame.elements.tets, corner) != node) continue;
    const double part = frame.elements.rest_elements[corner.tet].volume;
    sum += part * corner_stress(frame, corner);
    volume += part;
  }
  return sum / volume;
}

void add_node(const ProbedNode& probed, const Frame& frame, Sample& sample) {
  const NodeId node = node_at(frame.elements.tets, probed.corner);
  const NodeSeparation& separation = frame.nodes.separations[node];
  sample.displacement += probed.weight * (frame.nodes.positions[node] - frame.nodes.rest_positions[node]);
  sample.velocity += probed.weight * frame.nodes.velocities[node];
  sample.stress += probed.weight * stress_at(probed, node, frame);
  sample.utilization += probed.weight * separation.utilization;
  sample.separation_stress += probed.weight * separation.stress;
  sample.eigenvalue += probed.weight * separation.eigenvalue;
}

Vec3 total_reaction(const PlacedProbe& placed, const Frame& frame) {
  std::set<NodeId> nodes;
  for (const ProbedNode& probed : placed.nodes)
    for (const TetCorner& corner : probed.star) nodes.insert(node_at(frame.elements.tets, corner));
  Vec3 sum = Vec3::Zero();
  for (NodeId node : nodes) sum += frame.nodes.reactions[node];
  return sum;
}

Sample sample_at(const PlacedProbe& placed, const Frame& frame) {
  Sample sample;
  for (const ProbedNode& probed : placed.nodes) add_node(probed, frame, sample);
  sample.reaction = total_reaction(placed, frame);
  return sample;
}

struct Components {
  std::string_view name;
  std::vector<std::string_view> suffixes;  ///< with units
};

const Components& components(ProbeQuantity quantity) {
  static const std::array<Components, 6> kAll = {{
      {"displacement", {".x [m]", ".y [m]", ".z [m]"}},
      {"velocity", {".x [m/s]", ".y [m/s]", ".z [m/s]"}},
      {"stress", {".xx [Pa]", ".yy [Pa]", ".zz [Pa]", ".xy [Pa]", ".yz [Pa]", ".zx [Pa]"}},
      {"principal_stress", {".1 [Pa]", ".2 [Pa]", ".3 [Pa]"}},
      {"separation", {".utilization [-]", ".stress [Pa]", ".eigenvalue [N]"}},
      {"reaction", {".x [N]", ".y [N]", ".z [N]"}},
  }};
  return kAll[static_cast<std::size_t>(quantity)];
}

std::vector<double> values_of(const Vec3& vector) { return {vector.x(), vector.y(), vector.z()}; }

std::vector<double> values_of(ProbeQuantity quantity, const Sample& sample) {
  const Mat3& stress = sample.stress;
  switch (quantity) {
    case ProbeQuantity::displacement:
      return values_of(sample.displacement);
    case ProbeQuantity::velocity:
      return values_of(sample.velocity);
    case ProbeQuantity::stress:
      return {stress(0, 0), stress(1, 1), stress(2, 2), stress(0, 1), stress(1, 2), stress(2, 0)};
    case ProbeQuantity::principal_stress:
      return values_of(principal_stresses(stress));
    case ProbeQuantity::separation:
      return {sample.utilization, sample.separation_stress, sample.eigenvalue};
    case ProbeQuantity::reaction:
      return values_of(sample.reaction);
  }
  return {};
}

}  // namespace

void check_probes(const Scene& scene) {
  std::vector<std::string_view> names;
  for (const BodyDescription& body : scene.bodies) names.push_back(body.name);
  for (std::size_t i = 0; i < scene.probes.size(); ++i) {
    const std::string& name = scene.probes[i].body;
    if (std::ranges::find(names, name) != names.end()) continue;
    throw InputError(place_of(i, "body"), "names no body of the scene: \"" + name + "\"", suggestion(name, names));
  }
}

void place_probes(const Scene& scene, int scene_body, const RestBody& body, std::vector<PlacedProbe>& all,
                  std::vector<InputError>& findings) {
  const std::vector<Probe>& probes = scene.probes;
  all.resize(probes.size());
  for (std::size_t i = 0; i < probes.size(); ++i) {
    if (probes[i].body != scene.bodies[scene_body].name) continue;
    std::vector<ProbedNode> nodes = std::visit([&](const auto& place) { return nodes_at(body, place); }, probes[i].at);
    if (nodes.empty() && std::holds_alternative<ProbeNode>(probes[i].at)) {
      throw InputError(place_of(i, "at/node"), "is no node of the mesh",
                       "use one below " + std::to_string(1 + std::ranges::max(body.point_of_node)));
    }
    if (nodes.empty()) {
      findings.emplace_back(place_of(i, "at/region"), "holds no node",
                            "make it larger, or move it: regions are in the body's rest space");
    }
    all[i] = {probes[i], std::move(nodes)};
  }
}

std::vector<std::string> probe_columns(std::span<const PlacedProbe> probes) {
  std::vector<std::string> columns;
  for (const PlacedProbe& placed : probes)
    for (ProbeQuantity quantity : placed.probe.quantities)
      for (std::string_view suffix : components(quantity).suffixes)
        columns.push_back(placed.probe.name + "." + std::string(components(quantity).name) + std::string(suffix));
  return columns;
}

std::vector<double> probe_values(std::span<const PlacedProbe> probes, const Frame& frame) {
  std::vector<double> values;
  for (const PlacedProbe& placed : probes) {
    const Sample sample = sample_at(placed, frame);
    for (ProbeQuantity quantity : placed.probe.quantities) {
      std::vector<double> found = values_of(quantity, sample);
      if (placed.nodes.empty()) std::ranges::fill(found, std::numeric_limits<double>::quiet_NaN());
      values.insert(values.end(), found.begin(), found.end());
    }
  }
  return values;
}

}  // namespace griffith
