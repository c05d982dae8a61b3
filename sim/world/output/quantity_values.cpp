#include "sim/world/output/quantity_values.h"

#include <algorithm>
#include <cassert>
#include <type_traits>

#include "sim/core/parallel.h"
#include "sim/world/output/corner_state.h"

namespace griffith {
namespace {

template <class Sample>
Sample sample_at(const Frame& frame, std::size_t index);

template <>
NodeSample sample_at(const Frame& frame, std::size_t node) {
  return {frame.nodes.positions[node] - frame.nodes.rest_positions[node], frame.nodes.velocities[node],
          frame.nodes.reactions[node], frame.nodes.separations[node]};
}

template <>
ElementSample sample_at(const Frame& frame, std::size_t tet) {
  return {frame.elements.stresses[tet], frame.elements.states[tet].energy_density};
}

template <>
ShapeSample sample_at(const Frame& frame, std::size_t tet) {
  ShapeSample shape;
  for (std::size_t i = 0; i < 4; ++i) shape.corners[i] = frame.nodes.rest_positions[frame.elements.tets[tet][i]];
  return shape;
}

template <>
FaceSample sample_at(const Frame& frame, std::size_t face) {
  return {frame.time, frame.elements.opened[face / 4][face % 4]};
}

template <class Value, class Sample>
ValuePlace place_of_values(Value (*)(const Sample&)) {
  if (std::is_same_v<Sample, NodeSample>) return ValuePlace::node;
  return std::is_same_v<Sample, FaceSample> ? ValuePlace::face : ValuePlace::tet;
}
ValuePlace place_of_values(std::monostate) { return ValuePlace::tet; }

std::size_t value_count(const Frame& frame, ValuePlace place) {
  if (place == ValuePlace::node) return frame.nodes.positions.size();
  return (place == ValuePlace::tet ? 1 : 4) * frame.elements.tets.size();
}

/// Calls set(index, value) for each node, element or face, from many threads.
template <class Value, class Sample, class Set>
void for_each_value(const Frame& frame, Value (*function)(const Sample&), const Set& set) {
  constexpr int kGrain = 4096;
  parallel_for(static_cast<int>(value_count(frame, place_of_values(function))), kGrain, [&](int begin, int end) {
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      set(i, function(sample_at<Sample>(frame, i)));
  });
}
template <class Set>
void for_each_value(const Frame&, std::monostate, const Set&) {
  assert(!"a quantity that has values");
}

double scalar_of(double value) { return value; }
template <class Matrix>
double scalar_of(const Matrix& value) {
  return value.norm();
}

void fill_at_once(const Frame& frame, StressFunction function, std::span<float> values) {
  constexpr int kGrain = 4096;
  parallel_for(static_cast<int>(values.size()), kGrain, [&](int begin, int end) {
    const auto first = static_cast<std::size_t>(begin), count = static_cast<std::size_t>(end - begin);
    function(frame.elements.stresses.subspan(first, count), values.subspan(first, count));
  });
}

/// Calls set(index, value) for each corner of the tets, from many threads.
template <class Value, class Set>
void for_each_corner(const Frame& frame, Value (*function)(const ElementSample&), const Set& set) {
  constexpr int kGrain = 1024;
  parallel_for(static_cast<int>(frame.elements.tets.size()), kGrain, [&](int begin, int end) {
    for (int tet = begin; tet < end; ++tet)
      for (int corner = 0; corner < 4; ++corner) {
        const CornerState state = corner_state(frame, {TetId(tet), corner});
        set(static_cast<std::size_t>(4 * tet + corner), function({state.stress, state.energy_density}));
      }
  });
}
template <class Other, class Set>
void for_each_corner(const Frame&, Other, const Set&) {
  assert(!"a quantity of stresses");
}

bool is_of_stress(const Quantity& quantity) {
  return std::visit([]<class Function>(Function) { return std::is_invocable_v<Function, const ElementSample&>; },
                    quantity.function);
}

bool has_quadratic_tets(const Frame& frame) {
  return std::ranges::any_of(frame.elements.edges, [](const auto& edges) { return edges[0].valid(); });
}

/// Appends the values of a quantity of nodes in the middle of edges.
template <class Value, class Sample>
void append_middles(const Frame& frame, Value (*function)(const Sample&), std::vector<Value>& values) {
  if constexpr (std::is_same_v<Sample, NodeSample>) {
    for (std::size_t edge = 0; edge < frame.edges.ends.size(); ++edge) {
      const auto [a, b] = frame.edges.ends[edge];
      const NodeSample first = sample_at<NodeSample>(frame, static_cast<std::size_t>(a.index()));
      const NodeSample last = sample_at<NodeSample>(frame, static_cast<std::size_t>(b.index()));
      NodeSeparation separation = zero_separation();
      for (const NodeSample* end : {&first, &last}) add_separation(0.5, end->separation, separation);
      values.push_back(
          function({0.5 * (first.displacement + last.displacement) + frame.edges.offsets[edge],
                    0.5 * (first.velocity + last.velocity), 0.5 * (first.reaction + last.reaction), separation}));
    }
  }
}

template <class Value, class Sample>
QuantityArray array_of(const Frame& frame, Value (*function)(const Sample&)) {
  std::vector<Value> values(value_count(frame, place_of_values(function)));
  for_each_value(frame, function, [&](std::size_t i, const Value& value) { values[i] = value; });
  append_middles(frame, function, values);
  return values;
}
QuantityArray array_of(const Frame&, std::monostate) { return {}; }

}  // namespace

ValuePlace place_of(const Quantity& quantity) {
  return std::visit([](const auto function) { return place_of_values(function); }, quantity.function);
}

QuantityValues quantity_values(const Frame& frame, const Quantity& quantity) {
  QuantityValues result;
  result.place = place_of(quantity);
  result.values.resize(value_count(frame, result.place));
  if (quantity.function_of_many) {
    fill_at_once(frame, quantity.function_of_many, result.values);
    return result;
  }
  const auto set = [&](std::size_t i, const auto& value) { result.values[i] = static_cast<float>(scalar_of(value)); };
  std::visit([&](const auto function) { for_each_value(frame, function, set); }, quantity.function);
  return result;
}

QuantityValues linear_values(const Frame& frame, const Quantity& quantity) {
  if (!is_of_stress(quantity) || !has_quadratic_tets(frame)) return quantity_values(frame, quantity);
  QuantityValues result{ValuePlace::corner, std::vector<float>(value_count(frame, ValuePlace::corner))};
  const auto set = [&](std::size_t i, const auto& value) { result.values[i] = static_cast<float>(scalar_of(value)); };
  std::visit([&](const auto function) { for_each_corner(frame, function, set); }, quantity.function);
  return result;
}

NodeSeparation zero_separation() {
  NodeSeparation zero;
  zero.direction.setZero();
  zero.resistance = zero.fracture_energy = 0;
  return zero;
}

void add_separation(double weight, const NodeSeparation& separation, NodeSeparation& mean) {
  if (weight == 0) return;  // resistances may be infinite
  mean.tensor += weight * separation.tensor;
  mean.eigenvalue += weight * separation.eigenvalue;
  mean.direction += weight * separation.direction;
  mean.stress += weight * separation.stress;
  mean.resistance += weight * separation.resistance;
  mean.energy_release += weight * separation.energy_release;
  mean.fracture_energy += weight * separation.fracture_energy;
  mean.utilization += weight * separation.utilization;
}

QuantityArray quantity_array(const Frame& frame, const Quantity& quantity) {
  return std::visit([&](const auto function) { return array_of(frame, function); }, quantity.function);
}

}  // namespace griffith
