#pragma once

#include <random>

#include "sim/core/linear_algebra.h"

namespace griffith::testing {

/// Seeded random values: the same on every run.
class RandomValues {
 public:
  explicit RandomValues(unsigned seed) : engine_(seed) {}

  /// Uniform in [low, high).
  double uniform(double low = -1, double high = 1) {
    // The engine's bits alone: standard distributions differ between libraries.
    return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
  }
  int index(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }
  Vec3 vector(double size = 1) { return size * Vec3(uniform(), uniform(), uniform()); }
  Mat3 matrix(double size = 1) {
    Mat3 m;
    m << vector(size), vector(size), vector(size);
    return m;
  }
  Vec3 direction() {
    for (;;)
      if (const Vec3 v = vector(); v.squaredNorm() > 0.01 && v.squaredNorm() < 1) return v.normalized();
  }
  Mat3 rotation() { return Eigen::AngleAxisd(uniform(0, 3.14159), direction()).toRotationMatrix(); }

 private:
  std::mt19937 engine_;
};

}  // namespace griffith::testing
