#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/scene/scene.h"
#include "sim/world/output/frame.h"

namespace griffith::ui {

enum class SymbolKind { fracture_plane, contact, stress_axis, separation_axis };

/// Symbol of a layer that was picked in the view.
struct Symbol {
  SymbolKind kind = SymbolKind::fracture_plane;
  int index = 0;  ///< index of the crack event, the contact, the element or the node in the frame
  int axis = 0;   ///< index of an axis: 0 to 2 by ascending principal value

  bool operator==(const Symbol&) const = default;
};

/// Explanation of a symbol.
struct SymbolReport {
  struct Row {
    std::string label, value;
  };
  std::string title;     ///< "Crack plane"
  std::string sentence;  ///< what it means here
  std::vector<Row> rows;
};

/// Explains a symbol; empty if the frame does not have it. `duration`: time over which contacts acted [s].
std::optional<SymbolReport> symbol_report(const Symbol& symbol, const Frame& frame, const Scene& scene,
                                          double duration);

}  // namespace griffith::ui
