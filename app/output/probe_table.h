#pragma once

#include <filesystem>
#include <string>

#include "sim/world/world.h"

namespace griffith::app {

/// The values of a scene's probes as CSV (RFC 4180): step, time and one column a component, one row a frame from the
/// start on. Numbers are the shortest that read back as the same double; what does not exist is left empty.
class ProbeTable {
 public:
  /// Writes the heading and the row of the world as it is. Throws InputError, naming `scene`, when it has no probes.
  ProbeTable(const World& world, const std::filesystem::path& scene);

  void add(const World& world);
  const std::string& csv() const { return csv_; }

 private:
  std::string csv_;
};

}  // namespace griffith::app
