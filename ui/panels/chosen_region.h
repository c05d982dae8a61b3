#pragma once

#include <cstdint>
#include <optional>

#include "ui/model/scene_entry.h"
#include "ui/widgets/panel.h"

namespace griffith::ui {

/// The region of the chosen support, load or probe.
struct ChosenRegion {
  SceneEntry entry;
  int scene_body = 0;  ///< whose nodes it holds
  Region region;
};

/// Nothing where none is chosen, or away from the start of the scene's time: a scene says where regions are then.
std::optional<ChosenRegion> chosen_region(const Panel& panel);

/// Whether a gesture in the view that began with that entry, in that revision of the scene, has come to nothing:
/// something else is chosen by now (`now`), the scene has changed, or Escape was pressed.
bool gesture_lost(const Panel& panel, const std::optional<SceneEntry>& now, const SceneEntry& entry,
                  std::int64_t revision);

}  // namespace griffith::ui
