#include <functional>
#include <map>
#include <string>
#include <vector>

#include "bindings/c/guarded.h"
#include "bindings/c/handles.h"
#include "sim/world/energy/energy_account.h"
#include "sim/world/output/step_counters.h"

using namespace griffith;
using namespace griffith::c;

namespace {

/// A number of a frame.
struct ValueEntry {
  std::string name, unit, meaning;
  std::function<double(const World&)> read;
};

using Read = const World&;

std::vector<ValueEntry> make_entries() {
  std::vector<ValueEntry> entries = {
      {"step", "", "Steps made so far.", [](Read w) { return static_cast<double>(w.frame().step); }},
      {"time", "s", "Time since the start.", [](Read w) { return w.frame().time; }},
      {"time_step", "s", "Length of a step.", [](Read w) { return w.scene().simulation.time_step; }},
      {"bodies", "", "Connected pieces.", [](Read w) { return static_cast<double>(w.frame().bodies.size()); }},
      {"cracks", "", "Nodes that separated since the start.",
       [](Read w) { return static_cast<double>(w.frame().crack_events.size()); }},
      {"mass", "kg", "Total mass.", [](Read w) { return w.frame().totals.mass; }},
  };
  for (int axis = 0; axis < 3; ++axis) {
    const std::string suffix = {'_', "xyz"[axis]};
    entries.push_back(
        {"momentum" + suffix, "kg m/s", "Total momentum.", [axis](Read w) { return w.frame().totals.momentum[axis]; }});
    entries.push_back({"angular_momentum" + suffix, "kg m^2/s", "Angular momentum about the origin.",
                       [axis](Read w) { return w.frame().totals.angular_momentum[axis]; }});
  }
  for (const EnergyEntry& entry : energy_entries())
    entries.push_back({"energy_" + std::string(entry.key), "J", std::string(entry.meaning),
                       [value = entry.value](Read w) { return w.frame().energy.*value; }});
  entries.push_back({"energy_unaccounted", "J", "Energy that the account does not explain.",
                     [](Read w) { return w.frame().energy.unaccounted(); }});
  for (const StepCounter& counter : step_counters())
    entries.push_back({"step_" + std::string(counter.key), counter.unit == "-" ? "" : std::string(counter.unit),
                       std::string(counter.meaning), [value = counter.value](Read w) {
                         const StepReport report = w.frame().report;
                         return std::visit([&](auto member) { return static_cast<double>(report.*member); }, value);
                       }});
  return entries;
}

const std::vector<ValueEntry>& entries() {
  static const std::vector<ValueEntry> all = make_entries();
  return all;
}

const std::vector<griffith_value_info>& infos() {
  static const std::vector<griffith_value_info> all = [] {
    std::vector<griffith_value_info> made;
    for (const ValueEntry& entry : entries())
      made.push_back({entry.name.c_str(), entry.unit.c_str(), entry.meaning.c_str()});
    return made;
  }();
  return all;
}

const ValueEntry* find_entry(const std::string& name) {
  for (const ValueEntry& entry : entries())
    if (entry.name == name) return &entry;
  return nullptr;
}

}  // namespace

std::int32_t griffith_value_count(void) { return static_cast<std::int32_t>(entries().size()); }

const griffith_value_info* griffith_value_describe(std::int32_t index) {
  return index >= 0 && index < griffith_value_count() ? &infos()[index] : nullptr;
}

griffith_status griffith_world_value(const griffith_world* world, const char* name, double* value,
                                     griffith_error* error) {
  return guarded(error, [&] {
    const griffith_world& read = object_of(world, "world");
    double& result = object_of(value, "value");
    const ValueEntry* entry = find_entry(text_of(name, "name"));
    require(entry != nullptr, "name", "is not a number of a frame", "griffith_value_describe() lists them");
    result = entry->read(read.world);
  });
}
