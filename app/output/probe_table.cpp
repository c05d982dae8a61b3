#include "app/output/probe_table.h"

#include "app/output/csv_field.h"
#include "sim/core/number_text.h"
#include "sim/world/output/probes.h"

namespace griffith::app {

ProbeTable::ProbeTable(const World& world, const std::filesystem::path& scene) : csv_("step,time [s]") {
  if (world.frame().probes.empty())
    throw InputError(scene.string() + "#/probes", "are missing", "add a probe to the scene");
  for (const std::string& column : probe_columns(world.frame().probes)) csv_.append(",").append(csv_field(column));
  csv_ += "\n";
  add(world);
}

void ProbeTable::add(const World& world) {
  const Frame frame = world.frame();
  append_number(csv_, frame.step);
  append_csv_number(csv_, frame.time);
  for (const double value : probe_values(frame.probes, frame)) append_csv_number(csv_, value);
  csv_ += "\n";
}

}  // namespace griffith::app
