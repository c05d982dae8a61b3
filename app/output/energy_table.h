#pragma once

#include <string>

#include "sim/world/output/frame.h"

namespace griffith::app {

/// Energy account as CSV (RFC 4180): step, time, one column for each of energy_entries(), `unaccounted` and the area of
/// cracks, accumulated since the start, one row for each frame. Numbers are the shortest that read back as the same
/// double.
class EnergyTable {
 public:
  /// Writes the heading and the row of `frame`.
  explicit EnergyTable(const Frame& frame);

  void add(const Frame& frame);
  const std::string& csv() const { return csv_; }

 private:
  std::string csv_;
};

}  // namespace griffith::app
