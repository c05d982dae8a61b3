#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/bake/bake.h"
#include "app/export/tiny_gltf.h"

namespace griffith::app {

/// Growing binary part of a glTF file, in views by kind; all numbers of a mesh or an animation form an accessor in one
/// of them.
class GlbBuffer {
 public:
  // Each adds an accessor and returns its index. Vectors are stored in single precision.
  int add_vectors(std::span<const Vec3> vectors, bool with_bounds);
  int add_uvs(std::span<const Vec2> uvs);  ///< v downward, as in glTF
  int add_indices(std::span<const std::array<int, 3>> triangles);
  int add_key_times(std::span<const double> times);
  int add_key_vectors(std::span<const Vec3> vectors);
  int add_key_rotations(std::span<const Quat> rotations);
  int add_key_numbers(std::span<const float> numbers);

  /// Moves everything into the model.
  void finish(tinygltf::Model& model);

 private:
  enum View { kVectors, kUvs, kIndices, kKeys, kViews };

  /// `values`: consecutive elements of `components` numbers.
  template <class T>
  int add(View view, const std::vector<T>& values, int type, int components, bool with_bounds);

  std::vector<tinygltf::Accessor> accessors_;
  std::array<std::string, kViews> bytes_;
};

}  // namespace griffith::app
