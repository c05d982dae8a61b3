#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/scene/scene.h"
#include "sim/world/output/frame.h"

namespace griffith::ui {

/// Row of the outliner for a body with all its pieces, or for one piece.
struct BodyRow {
  std::string name;
  int scene_body = 0;
  BodyId piece;                            ///< invalid: all pieces of the body
  int elastic = 0, rigid = 0, asleep = 0;  ///< number of pieces in each state
  int tets = 0;
  double mass = 0;                           ///< [kg]
  std::optional<ScaledImpact> broke_scaled;  ///< scaling of the piece that broke with the smallest stiffness factor

  int pieces() const { return elastic + rigid + asleep; }
  /// Returns "E/256, σ/16" if material broke while it was scaled, else an empty text.
  std::string mark() const;
  /// Returns the most active state of its pieces.
  std::string_view state() const { return elastic > 0 ? "elastic" : rigid > 0 ? "rigid" : asleep > 0 ? "asleep" : ""; }
};

/// Returns one row for each body of the scene, in order; bodies without a piece in the frame have empty rows.
std::vector<BodyRow> body_rows(const Scene& scene, const Frame& frame);
/// Returns one row for each piece that has tets.
std::vector<BodyRow> piece_rows(const Scene& scene, const Frame& frame);

/// Sort keys of rows.
enum class BodyColumn { name, state, pieces, tets, mass };
/// Sorts rows; equal rows keep their order.
void sort_rows(std::vector<BodyRow>& rows, BodyColumn column, bool descending);

/// True if a text contains `part`, in any case.
bool holds_text(std::string_view text, std::string_view part);
/// Keeps the rows whose name, state or mark holds `text`, in any case.
void filter_rows(std::vector<BodyRow>& rows, std::string_view text);

}  // namespace griffith::ui
