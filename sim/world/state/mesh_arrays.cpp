#include "sim/world/state/mesh_arrays.h"

#include <algorithm>

namespace griffith {
namespace {

template <class T>
std::vector<T>& editable(std::vector<T>& array) {
  return array;
}
template <class T>
std::vector<T>& editable(SharedArray<T>& array) {
  return array.edit();
}

/// Appends a copy of an entry of the same array.
template <class T>
void append_entry(std::vector<T>& array, std::size_t original) {
  array.push_back(T(array[original]));  // the entry moves while the array grows
}

/// Returns the size of one entry of all arrays [bytes].
template <class Arrays>
std::size_t entry_size() {
  std::size_t size = 0;
  Arrays::each_array(Arrays(), [&](const auto&, const auto& fresh) { size += sizeof(fresh); });
  return size;
}

/// Makes strains, which are zero for new tets.
void make_strains(ElementArrays& elements) {
  elements.plastic_strains.resize(elements.states.size(), Mat3::Zero());
  elements.similarity_strains.resize(elements.states.size(), Mat3::Zero());
}

void make_point_strains(ElementArrays& elements) {
  elements.point_strains.resize(elements.states.size(), at_all_corners(Mat3::Zero()));
}

}  // namespace

std::size_t NodeArrays::memory() const { return positions.size() * entry_size<NodeArrays>(); }
std::size_t ElementArrays::memory(const ElementArrays* beside) const {
  std::vector<const void*> counted;  // what lies at the same place is the same
  if (beside) each_array(*beside, [&](const auto& array, const auto&) { counted.push_back(array.data()); });
  std::size_t size = 2 * plastic_strains.size() * sizeof(Mat3) + point_strains.size() * sizeof(CornerTensors), i = 0;
  if (!beside || !quadratic_states.shares_with(beside->quadratic_states))
    size += quadratic_states.size() * sizeof(QuadraticState);
  each_array(*this, [&](const auto& array, const auto& fresh) {
    if (!beside || array.data() != counted[i++]) size += array.size() * sizeof(fresh);
  });
  return size;
}

void NodeArrays::resize(std::size_t count) {
  each_array(*this, [&](auto& array, const auto& fresh) { editable(array).resize(count, fresh); });
}

void NodeArrays::append_copy(NodeId original) {
  each_array(*this, [&](auto& array, const auto&) { append_entry(editable(array), original); });
  at_crack_front.back() = 0;
  rows.back() = -1;
  separations.back() = {};
  reactions.back().setZero();
}

void NodeArrays::append_between(const EdgeNode& node) {
  resize(positions.size() + 1);
  const auto interpolate = [&](auto& array) { array.back() = node.interpolate(array[node.a], array[node.b]); };
  interpolate(positions), interpolate(velocities), interpolate(strength_factors);
}

void EdgeArrays::resize(std::size_t count) {
  offsets.resize(count, Vec3::Zero()), velocities.resize(count, Vec3::Zero());
  masses.resize(count, 0.0), rows.resize(count, -1);
}

void EdgeArrays::append_part(const EdgePart& part) {
  resize(offsets.size() + 1);
  for (std::size_t i = 0; i < part.from.size() && part.from[i].valid(); ++i) {
    offsets.back() += part.weights[i] * offsets[part.from[i]];
    velocities.back() += part.weights[i] * velocities[part.from[i]];
  }
}

void EdgeArrays::append_copy(EdgeId original) {
  append_entry(offsets, original), append_entry(velocities, original), append_entry(masses, original);
  rows.push_back(-1);
}

void ElementArrays::resize(std::size_t count) {
  each_array(*this, [&](auto& array, const auto& fresh) { editable(array).resize(count, fresh); });
  if (!quadratic_states.empty()) quadratic_states.edit().resize(count);
  if (!plastic_strains.empty()) make_strains(*this);
  if (!point_strains.empty()) make_point_strains(*this);
}

void ElementArrays::append_copy(TetId original) {
  each_array(*this, [&](auto& array, const auto&) { append_entry(editable(array), original); });
  if (!quadratic_states.empty()) append_entry(quadratic_states.edit(), original);
  if (!point_strains.empty()) append_entry(point_strains, original);
  if (plastic_strains.empty()) return;
  append_entry(plastic_strains, original);
  append_entry(similarity_strains, original);
}

void ElementArrays::share_point_strains(const TetBisection& halves, double weight) {
  if (point_strains.empty()) return;
  CornerTensors of_tet = at_corners(point_strains[halves.tet]), of_child = of_tet;
  const Mat3 middle = (1 - weight) * of_tet[halves.kept] + weight * of_tet[halves.moved];
  of_tet[halves.moved] = of_child[halves.kept] = middle;
  point_strains[halves.tet] = at_integration_points(of_tet);
  point_strains[halves.child] = at_integration_points(of_child);
}

void ElementArrays::allow_strains() {
  if (plastic_strains.empty()) make_strains(*this);
}

void ElementArrays::allow_point_strains() {
  if (point_strains.empty()) make_point_strains(*this);
}

void ElementArrays::remove_undefined_strains(TetId tet) {
  if (!plastic_strain(tet).allFinite()) plastic_strains[tet].setZero();
  if (point_strains.empty()) return;
  for (Mat3& strain : point_strains[tet])
    if (!strain.allFinite()) strain.setZero();
}

bool ElementArrays::has_flowed_at_points() const {
  return std::ranges::any_of(point_strains, [](const CornerTensors& strains) {
    return std::ranges::any_of(strains, [](const Mat3& strain) { return !strain.isZero(0); });
  });
}

CornerTensors ElementArrays::corner_stress_free_strains(TetId tet) const {
  CornerTensors strains = at_all_corners(stress_free_strain(tet));
  if (point_strains.empty()) return strains;
  const CornerTensors plastic = at_corners(point_strains[tet]);
  for (int v = 0; v < 4; ++v) strains[v] += plastic[v];
  return strains;
}

std::vector<CornerTensors> turned_strains(const ElementArrays& elements, std::span<const TetId> tets,
                                          const Mat3& turn) {
  std::vector<CornerTensors> turned;
  for (const TetId tet : tets) {
    turned.push_back(elements.corner_stress_free_strains(tet));
    for (Mat3& strain : turned.back()) strain = turn * strain * turn.transpose();
  }
  return turned;
}

}  // namespace griffith
