#pragma once

#include <filesystem>
#include <string>

#include "sim/world/world.h"

namespace griffith::app {

/// Values of a scene's probes as CSV (RFC 4180): step, time and one column for each component, one row for each frame.
/// Numbers are the shortest that read back as the same double; missing values are left empty.
class ProbeTable {
 public:
  /// Writes the heading and the row of the current world. Throws InputError, naming `scene`, if it has no probes.
  ProbeTable(const World& world, const std::filesystem::path& scene);

  void add(const World& world);
  const std::string& csv() const { return csv_; }

 private:
  std::string csv_;
};

}  // namespace griffith::app
