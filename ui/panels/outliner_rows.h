#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ui/model/scene_entry.h"
#include "ui/panels/body_rows.h"

namespace griffith::ui {

/// What the outliner shows of a part of the scene, or of a piece of a body.
struct OutlinerRow {
  SceneEntry entry;
  std::string tag;   ///< "bodies/0", "bodies/0/supports/1"
  std::string name;  ///< "wall", "Support 2"
  std::string note;  ///< "fixed", "40 m/s"; of bodies empty
  BodyRow body;      ///< of bodies and pieces alone
};

/// Rows of the bodies in the order of `bodies`, each with those of its supports and loads, then of projectiles, probes
/// and cameras: as far as their name, note or state hold `filter`, what belongs to a body with it.
std::vector<OutlinerRow> outliner_rows(const Scene& scene, const std::vector<BodyRow>& bodies, std::string_view filter);
/// Rows of pieces, as far as their name or state hold `filter`.
std::vector<OutlinerRow> outliner_piece_rows(std::vector<BodyRow> pieces, std::string_view filter);

}  // namespace griffith::ui
