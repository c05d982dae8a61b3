#include "sim/world/mesh_arrays.h"

namespace griffith {
namespace {

/// Appends a copy of an entry of the same array.
template <class T>
void append_entry(std::vector<T>& array, std::size_t original) {
  array.push_back(T(array[original]));  // the entry moves while the array grows
}

/// Size of one entry of all arrays [bytes].
template <class Arrays>
std::size_t entry_size() {
  std::size_t size = 0;
  Arrays::each_array(Arrays(), [&](const auto&, const auto& fresh) { size += sizeof(fresh); });
  return size;
}

}  // namespace

std::size_t NodeArrays::memory() const { return positions.size() * entry_size<NodeArrays>(); }
std::size_t ElementArrays::memory() const { return states.size() * entry_size<ElementArrays>(); }

void NodeArrays::resize(std::size_t count) {
  each_array(*this, [&](auto& array, const auto& fresh) { array.resize(count, fresh); });
}

void NodeArrays::append_copy(NodeId original) {
  each_array(*this, [&](auto& array, const auto&) { append_entry(array, original); });
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

void ElementArrays::resize(std::size_t count) {
  each_array(*this, [&](auto& array, const auto& fresh) { array.resize(count, fresh); });
}

void ElementArrays::append_copy(TetId original) {
  each_array(*this, [&](auto& array, const auto&) { append_entry(array, original); });
}

}  // namespace griffith
