#include "sim/world/output/probes.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <limits>
#include <set>

#include "sim/core/error.h"
#include "sim/geometry/triangle.h"
#include "sim/scene/field.h"
#include "sim/scene/quantities.h"
#include "sim/world/bodies/surface_point.h"
#include "sim/world/output/corner_state.h"
#include "sim/world/output/quantity_values.h"
#include "sim/world/state/world_state.h"

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

std::string place_of(std::size_t probe, const std::string& field) {
  return "#/probes/" + std::to_string(probe) + "/" + field;
}

void check_quantities(const Probe& probe, std::size_t index) {
  const std::vector<std::string_view> known = keys_of(probe_quantities());
  for (std::size_t i = 0; i < probe.quantities.size(); ++i) {
    const std::string& key = probe.quantities[i];
    if (std::ranges::find(known, key) != known.end()) continue;
    throw InputError(place_of(index, "quantities/" + std::to_string(i)), "is no quantity of probes: \"" + key + "\"",
                     suggestion(key, known));
  }
}

// --- What it measures -----------------------------------------------------------------------------------------------

/// Means over a probe's nodes; `reaction` is a sum.
struct ProbeSample {
  Vec3 displacement = Vec3::Zero(), velocity = Vec3::Zero(), reaction = Vec3::Zero();
  NodeSeparation separation = zero_separation();
  Mat3 stress = Mat3::Zero();
  double energy_density = 0;

  NodeSample node() const { return {displacement, velocity, reaction, separation}; }
  ElementSample element() const { return {stress, energy_density}; }
};

/// Returns the mean over the elements at a node, weighted by their volumes.
CornerState state_at(const ProbedNode& probed, NodeId node, const Frame& frame) {
  CornerState sum;
  double volume = 0;
  for (const TetCorner& corner : probed.star) {
    if (node_at(frame.elements.tets, corner) != node) continue;
    const double part = frame.elements.rest_elements[corner.tet].volume;
    const CornerState state = corner_state(frame, corner);
    sum.stress += part * state.stress;
    sum.energy_density += part * state.energy_density;
    volume += part;
  }
  return {sum.stress / volume, sum.energy_density / volume};
}

void add_node(const ProbedNode& probed, const Frame& frame, ProbeSample& sample) {
  const NodeId node = node_at(frame.elements.tets, probed.corner);
  const CornerState state = state_at(probed, node, frame);
  sample.displacement += probed.weight * (frame.nodes.positions[node] - frame.nodes.rest_positions[node]);
  sample.velocity += probed.weight * frame.nodes.velocities[node];
  sample.stress += probed.weight * state.stress;
  sample.energy_density += probed.weight * state.energy_density;
  add_separation(probed.weight, frame.nodes.separations[node], sample.separation);
}

Vec3 total_reaction(const PlacedProbe& placed, const Frame& frame) {
  std::set<NodeId> nodes;
  for (const ProbedNode& probed : placed.nodes)
    for (const TetCorner& corner : probed.star) nodes.insert(node_at(frame.elements.tets, corner));
  Vec3 sum = Vec3::Zero();
  for (NodeId node : nodes) sum += frame.nodes.reactions[node];
  return sum;
}

ProbeSample sample_at(const PlacedProbe& placed, const Frame& frame) {
  ProbeSample sample;
  for (const ProbedNode& probed : placed.nodes) add_node(probed, frame, sample);
  sample.reaction = total_reaction(placed, frame);
  return sample;
}

std::vector<double> components_of(double value) { return {value}; }
std::vector<double> components_of(const Vec3& value) { return {value.x(), value.y(), value.z()}; }
std::vector<double> components_of(const Mat3& value) {
  return {value(0, 0), value(1, 1), value(2, 2), value(0, 1), value(1, 2), value(2, 0)};
}

template <class Value>
std::vector<double> values_of(Value (*function)(const NodeSample&), const ProbeSample& sample) {
  return components_of(function(sample.node()));
}
template <class Value>
std::vector<double> values_of(Value (*function)(const ElementSample&), const ProbeSample& sample) {
  return components_of(function(sample.element()));
}
/// Other quantities are not in probe_quantities().
template <class Function>
std::vector<double> values_of(Function, const ProbeSample&) {
  return {};
}

std::vector<double> values_of(const Quantity& quantity, const ProbeSample& sample) {
  return std::visit([&](const auto function) { return values_of(function, sample); }, quantity.function);
}

/// Appends the names of a quantity's columns: "probe.stress.xx [Pa]", "probe.von_mises [Pa]".
void add_columns(const std::string& probe, const Quantity& quantity, std::vector<std::string>& columns) {
  const std::string name = probe + "." + std::string(quantity.key);
  const std::string unit = quantity.unit.empty() ? "" : " [" + std::string(quantity.unit) + "]";
  if (quantity.components[0].empty()) columns.push_back(name + unit);
  for (std::string_view component : quantity.components)
    if (!component.empty()) columns.push_back(name + "." + std::string(component) + unit);
}

}  // namespace

void check_probes(const Scene& scene) {
  std::vector<std::string_view> names;
  for (const BodyDescription& body : scene.bodies) names.push_back(body.name);
  for (std::size_t i = 0; i < scene.probes.size(); ++i) {
    check_quantities(scene.probes[i], i);
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
    for (const std::string& key : placed.probe.quantities) add_columns(placed.probe.name, *find_quantity(key), columns);
  return columns;
}

std::vector<double> probe_values(std::span<const PlacedProbe> probes, const Frame& frame) {
  std::vector<double> values;
  for (const PlacedProbe& placed : probes) {
    const ProbeSample sample = sample_at(placed, frame);
    for (const std::string& key : placed.probe.quantities) {
      std::vector<double> found = values_of(*find_quantity(key), sample);
      if (placed.nodes.empty()) std::ranges::fill(found, std::numeric_limits<double>::quiet_NaN());
      values.insert(values.end(), found.begin(), found.end());
    }
  }
  return values;
}

}  // namespace griffith
