#pragma once

#include <string_view>
#include <vector>

#include "sim/scene/boundary_condition.h"

namespace griffith::ui {

/// Fields of a support or load that its kind does not use.
inline std::vector<std::string_view> idle_fields(const Support& support) {
  if (support.kind == SupportKind::sliding) return {"velocity", "stop"};
  if (support.kind == SupportKind::prescribed) return {"normal"};
  return {"normal", "velocity", "stop"};
}
inline std::vector<std::string_view> idle_fields(const Load& load) {
  std::vector<std::string_view> fields = {"force", "traction", "pressure", "acceleration"};  // by LoadKind
  fields.erase(fields.begin() + static_cast<int>(load.kind));
  return fields;
}
template <class T>
std::vector<std::string_view> idle_fields(const T&) {
  return {};
}

/// Resets the fields of a support or load that its kind does not use.
inline void drop_idle_fields(Support& support) {
  const Support of_none;
  if (support.kind != SupportKind::sliding) support.normal = of_none.normal;
  if (support.kind == SupportKind::prescribed) return;
  support.velocity = of_none.velocity;
  support.stop = of_none.stop;
}
inline void drop_idle_fields(Load& load) {
  const Load of_none;
  if (load.kind != LoadKind::point_force) load.force = of_none.force;
  if (load.kind != LoadKind::traction) load.traction = of_none.traction;
  if (load.kind != LoadKind::pressure) load.pressure = of_none.pressure;
  if (load.kind != LoadKind::body_force) load.acceleration = of_none.acceleration;
}
template <class T>
void drop_idle_fields(T&) {}

}  // namespace griffith::ui
