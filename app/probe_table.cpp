#include "app/probe_table.h"

#include <charconv>
#include <cmath>

#include "sim/world/probes.h"

namespace griffith::app {
namespace {

std::string number_text(double value) {
  if (!std::isfinite(value)) return "";
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

/// In quotation marks where it would not be one field without them.
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
  csv_.append(std::to_string(frame.step)).append(",").append(number_text(frame.time));
  for (const double value : probe_values(frame.probes, frame)) csv_.append(",").append(number_text(value));
  csv_ += "\n";
}

}  // namespace griffith::app
