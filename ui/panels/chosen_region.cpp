#include "ui/panels/chosen_region.h"

#include "ui/model/entry_choice.h"
#include "ui/model/entry_place.h"

namespace griffith::ui {

std::optional<ChosenRegion> chosen_region(const Panel& panel) {
  if (panel.input.frame.step != 0) return std::nullopt;
  const Scene& scene = panel.history.scene();
  const std::optional<SceneEntry> entry = active_entry(panel.state, scene);
  const std::optional<int> body = entry ? body_of(scene, *entry) : std::nullopt;
  if (!body || !region_of(scene, *entry)) return std::nullopt;
  return ChosenRegion{*entry, *body, *region_of(scene, *entry)};
}

bool gesture_lost(const Panel& panel, const std::optional<SceneEntry>& now, const SceneEntry& entry,
                  std::int64_t revision) {
  return now != entry || panel.history.revision() != revision || ImGui::IsKeyPressed(key::kEscape, false);
}

}  // namespace griffith::ui
