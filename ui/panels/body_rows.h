#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/scene/scene.h"
#include "sim/world/frame.h"

namespace griffith::ui {

/// What the list of bodies shows of a body of the scene with all its pieces, or of one piece.
struct BodyRow {
  std::string name;
  int scene_body = 0;
  BodyId piece;                            ///< invalid: all pieces of the scene's body
  int elastic = 0, rigid = 0, asleep = 0;  ///< how many pieces are so
  int tets = 0;
  double mass = 0;                           ///< [kg]
  std::optional<ScaledImpact> broke_scaled;  ///< of the piece that broke at the smallest f

  int pieces() const { return elastic + rigid + asleep; }
  /// "E/256, σ/16" of what broke while it was scaled, else nothing.
  std::string mark() const;
  /// State of its liveliest piece.
  std::string_view state() const { return elastic > 0 ? "elastic" : rigid > 0 ? "rigid" : asleep > 0 ? "asleep" : ""; }
};

/// One row a body of the scene, in its order; those that have no piece in the frame are empty.
std::vector<BodyRow> body_rows(const Scene& scene, const Frame& frame);
/// One row a piece that has tets.
std::vector<BodyRow> piece_rows(const Scene& scene, const Frame& frame);

/// What rows are sorted by.
enum class BodyColumn { name, state, pieces, tets, mass };
/// Equal ones keep their order.
void sort_rows(std::vector<BodyRow>& rows, BodyColumn column, bool descending);

/// Whether a text holds a part of it, in any case.
bool holds_text(std::string_view text, std::string_view part);
/// Keeps the rows whose name, state or mark holds `text`, in any case.
void filter_rows(std::vector<BodyRow>& rows, std::string_view text);

}  // namespace griffith::ui
