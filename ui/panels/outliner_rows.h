#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ui/model/scene_entry.h"
#include "ui/panels/body_rows.h"

namespace griffith::ui {

/// Row of the outliner for a part of the scene or a piece of a body.
struct OutlinerRow {
  SceneEntry entry;
  std::string tag;   ///< "bodies/0", "bodies/0/supports/1"
  std::string name;  ///< "wall", "Support 2"
  std::string note;  ///< "fixed", "40 m/s"; empty for bodies
  BodyRow body;      ///< values of bodies and pieces
};

/// Returns the rows of bodies in the order of `bodies`, each followed by its supports and loads, then of projectiles,
/// probes and cameras. Only rows whose name, note or state contains `filter`; a matching body keeps its parts.
std::vector<OutlinerRow> outliner_rows(const Scene& scene, const std::vector<BodyRow>& bodies, std::string_view filter);
/// Returns the rows of pieces whose name or state contains `filter`.
std::vector<OutlinerRow> outliner_piece_rows(std::vector<BodyRow> pieces, std::string_view filter);

}  // namespace griffith::ui
