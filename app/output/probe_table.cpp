#include "app/output/probe_table.h"

#include <cmath>

#include "sim/mesh/number_text.h"
#include "sim/world/conditions/probes.h"

namespace griffith::app {
namespace {

void append_field(std::string& csv, double value) {
  csv += ',';
  if (std::isfinite(value)) append_number(csv, value);
}

/// Puts quotation marks where it would not be one field without them.
std::string field_text(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + "\"";
}

}  // namespace

ProbeTable::ProbeTable(const World& world, const std::filesystem::path& scene) : csv_("step,time [s]") {
  if (world.frame().probes.empty())
    throw InputError(scene.string() + "#/probes", "are none", "add a probe to the scene");
  for (const std::string& column : probe_columns(world.frame().probes)) csv_.append(",").append(field_text(column));
  csv_ += "\n";
  add(world);
}

void ProbeTable::add(const World& world) {
  const Frame frame = world.frame();
  append_number(csv_, frame.step);
  append_field(csv_, frame.time);
  for (const double value : probe_values(frame.probes, frame)) append_field(csv_, value);
  csv_ += "\n";
}

}  // namespace griffith::app
