#pragma once

#include <cstdint>
#include <optional>

#include "ui/model/scene_entry.h"
#include "ui/widgets/panel.h"

namespace griffith::ui {

/// Region of the active support, load or probe.
struct ChosenRegion {
  SceneEntry entry;
  int scene_body = 0;  ///< body to which the nodes belong
  Region region;
};

/// Returns the active region; empty if there is none or the simulation is not at its start, where scenes define
/// regions.
std::optional<ChosenRegion> chosen_region(const Panel& panel);

/// True if a gesture in the view must end: another entry is active by now (`now`), the scene has changed since
/// `revision`, or Escape was pressed.
bool gesture_lost(const Panel& panel, const std::optional<SceneEntry>& now, const SceneEntry& entry,
                  std::int64_t revision);

}  // namespace griffith::ui
