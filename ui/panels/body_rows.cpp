#include "ui/panels/body_rows.h"

#include <algorithm>
#include <cctype>

namespace griffith::ui {
namespace {

void add(BodyRow& row, const BodyView& piece) {
  ++(piece.asleep ? row.asleep : piece.rigid ? row.rigid : row.elastic);
  row.tets += piece.tets;
  row.mass += piece.mass;
  keep_least(row.broke_scaled, piece.broke_scaled);
}

/// Natural order of names: digits compare as numbers, so that "brick 2" precedes "brick 10".
bool comes_before(std::string_view a, std::string_view b) {
  const auto is_digit = [](unsigned char letter) { return std::isdigit(letter) != 0; };
  while (!a.empty() && !b.empty()) {
    const auto digits_a = std::ranges::find_if_not(a, is_digit) - a.begin();
    const auto digits_b = std::ranges::find_if_not(b, is_digit) - b.begin();
    if (digits_a > 0 && digits_b > 0 && digits_a != digits_b) return digits_a < digits_b;
    if (a.front() != b.front()) return a.front() < b.front();
    a.remove_prefix(1);
    b.remove_prefix(1);
  }
  return a.size() < b.size();
}

}  // namespace

std::string BodyRow::mark() const { return broke_scaled ? scale_text(*broke_scaled) : ""; }

std::vector<BodyRow> body_rows(const Scene& scene, const Frame& frame) {
  std::vector<BodyRow> rows(scene.bodies.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].name = scene.bodies[i].name;
    rows[i].scene_body = static_cast<int>(i);
  }
  for (const BodyView& piece : frame.bodies)
    if (piece.tets > 0 && static_cast<std::size_t>(piece.scene_body) < rows.size()) add(rows[piece.scene_body], piece);
  return rows;
}

std::vector<BodyRow> piece_rows(const Scene& scene, const Frame& frame) {
  std::vector<BodyRow> rows;
  for (const BodyView& piece : frame.bodies) {
    if (piece.tets == 0 || static_cast<std::size_t>(piece.scene_body) >= scene.bodies.size()) continue;
    BodyRow& row = rows.emplace_back();
    row.name = scene.bodies[piece.scene_body].name + " #" + std::to_string(piece.id.index());
    row.scene_body = piece.scene_body;
    row.piece = piece.id;
    add(row, piece);
  }
  return rows;
}

void sort_rows(std::vector<BodyRow>& rows, BodyColumn column, bool descending) {
  const auto less = [column](const BodyRow& a, const BodyRow& b) {
    switch (column) {
      case BodyColumn::name:
        return comes_before(a.name, b.name);
      case BodyColumn::state:
        return a.state() < b.state();
      case BodyColumn::pieces:
        return a.pieces() < b.pieces();
      case BodyColumn::tets:
        return a.tets < b.tets;
      case BodyColumn::mass:
        return a.mass < b.mass;
    }
    return false;
  };
  std::ranges::stable_sort(rows,
                           [&](const BodyRow& a, const BodyRow& b) { return descending ? less(b, a) : less(a, b); });
}

bool holds_text(std::string_view text, std::string_view part) {
  const auto same = [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); };
  return !std::ranges::search(text, part, same).empty() || part.empty();
}

void filter_rows(std::vector<BodyRow>& rows, std::string_view text) {
  std::erase_if(rows, [text](const BodyRow& row) {
    return !holds_text(row.name, text) && !holds_text(row.state(), text) && !holds_text(row.mark(), text);
  });
}

}  // namespace griffith::ui
