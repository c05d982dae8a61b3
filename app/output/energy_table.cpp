#include "app/output/energy_table.h"

#include "app/output/csv_field.h"
#include "sim/core/number_text.h"

namespace griffith::app {

EnergyTable::EnergyTable(const Frame& frame) : csv_("step,time [s]") {
  for (const EnergyEntry& entry : energy_entries()) csv_.append(",").append(entry.key).append(" [J]");
  csv_ += ",unaccounted [J],crack_area [m²]\n";
  add(frame);
}

void EnergyTable::add(const Frame& frame) {
  append_number(csv_, frame.step);
  const auto append = [&](double value) { append_csv_number(csv_, value); };
  append(frame.time);
  for (const EnergyEntry& entry : energy_entries()) append(frame.energy.*entry.value);
  append(frame.energy.unaccounted());
  append(frame.energy.crack_area);
  csv_ += "\n";
}

}  // namespace griffith::app
