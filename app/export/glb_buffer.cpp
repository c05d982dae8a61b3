#include "app/export/glb_buffer.h"

#include <algorithm>
#include <cstring>

namespace griffith::app {
namespace {

template <class Vectors>
std::vector<float> single_precision(const Vectors& vectors) {
  std::vector<float> values;
  for (const auto& vector : vectors)
    for (const double value : vector) values.push_back(static_cast<float>(value));
  return values;
}

}  // namespace

template <class T>
int GlbBuffer::add(View view, const std::vector<T>& values, int type, int components, bool with_bounds) {
  tinygltf::Accessor accessor;
  accessor.bufferView = view;
  accessor.byteOffset = bytes_[view].size();
  accessor.componentType =
      std::is_same_v<T, float> ? TINYGLTF_COMPONENT_TYPE_FLOAT : TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  accessor.count = values.size() / components;
  accessor.type = type;
  for (int i = 0; with_bounds && i < components; ++i) {
    double minimum = values[i], maximum = values[i];
    for (std::size_t k = i; k < values.size(); k += components) {
      minimum = std::min(minimum, static_cast<double>(values[k]));
      maximum = std::max(maximum, static_cast<double>(values[k]));
    }
    accessor.minValues.push_back(minimum);
    accessor.maxValues.push_back(maximum);
  }
  bytes_[view].append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  accessors_.push_back(accessor);
  return static_cast<int>(accessors_.size()) - 1;
}

int GlbBuffer::add_vectors(std::span<const Vec3> vectors, bool with_bounds) {
  return add(kVectors, single_precision(vectors), TINYGLTF_TYPE_VEC3, 3, with_bounds);
}

int GlbBuffer::add_uvs(std::span<const Vec2> uvs) {
  std::vector<float> values;
  for (const Vec2& uv : uvs) values.insert(values.end(), {static_cast<float>(uv.x()), static_cast<float>(1 - uv.y())});
  return add(kUvs, values, TINYGLTF_TYPE_VEC2, 2, false);
}

int GlbBuffer::add_indices(std::span<const std::array<int, 3>> triangles) {
  std::vector<std::uint32_t> values;
  for (const std::array<int, 3>& triangle : triangles) values.insert(values.end(), triangle.begin(), triangle.end());
  return add(kIndices, values, TINYGLTF_TYPE_SCALAR, 1, false);
}

int GlbBuffer::add_key_times(std::span<const double> times) {
  return add(kKeys, std::vector<float>(times.begin(), times.end()), TINYGLTF_TYPE_SCALAR, 1, true);
}

int GlbBuffer::add_key_vectors(std::span<const Vec3> vectors) {
  return add(kKeys, single_precision(vectors), TINYGLTF_TYPE_VEC3, 3, false);
}

int GlbBuffer::add_key_rotations(std::span<const Quat> rotations) {
  std::vector<float> values;
  for (const Quat& rotation : rotations)
    for (const double value : rotation.coeffs()) values.push_back(static_cast<float>(value));
  return add(kKeys, values, TINYGLTF_TYPE_VEC4, 4, false);
}

int GlbBuffer::add_key_numbers(std::span<const float> numbers) {
  return add(kKeys, std::vector<float>(numbers.begin(), numbers.end()), TINYGLTF_TYPE_SCALAR, 1, false);
}

void GlbBuffer::finish(tinygltf::Model& model) {
  constexpr std::size_t kStrides[kViews] = {sizeof(float[3]), sizeof(float[2]), 0, 0};
  constexpr int kTargets[kViews] = {TINYGLTF_TARGET_ARRAY_BUFFER, TINYGLTF_TARGET_ARRAY_BUFFER,
                                    TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER, 0};
  tinygltf::Buffer buffer;
  for (int i = 0; i < kViews; ++i) {
    if (bytes_[i].empty()) bytes_[i].resize(sizeof(float));  // views must not be empty
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = buffer.data.size();
    view.byteLength = bytes_[i].size();
    view.byteStride = kStrides[i];
    view.target = kTargets[i];
    buffer.data.insert(buffer.data.end(), bytes_[i].begin(), bytes_[i].end());
    model.bufferViews.push_back(view);
  }
  model.buffers.push_back(std::move(buffer));
  model.accessors = std::move(accessors_);
}

}  // namespace griffith::app
