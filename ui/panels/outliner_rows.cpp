#include "ui/panels/outliner_rows.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include "ui/model/units.h"
#include "ui/widgets/field_widgets.h"

namespace griffith::ui {
namespace {

std::string kind_note(const Support& support) {
  constexpr const char* kNames[] = {"fixed", "sliding", "prescribed"};  // by SupportKind
  return kNames[static_cast<std::size_t>(support.kind)];
}

std::string kind_note(const Load& load) {
  constexpr const char* kNames[] = {"point force", "traction", "pressure", "body force"};  // by LoadKind
  return kNames[static_cast<std::size_t>(load.kind)];
}

std::string kind_note(const ProjectileBurst& burst) {
  const std::string speed = format_quantity(burst.speed, "m/s", 3);
  return burst.count == 1 ? speed : std::to_string(burst.count) + " × " + speed;
}

std::string kind_note(const Probe& probe) { return "of " + probe.body; }
std::string kind_note(const Camera&) { return "camera"; }
std::string kind_note(const BodyDescription&) { return ""; }

std::string tag_of(const SceneEntry& entry) {
  constexpr const char* kLists[] = {"bodies", "supports", "loads", "projectiles", "probes", "cameras"};
  const std::string list = kLists[static_cast<std::size_t>(entry.kind)], number = std::to_string(entry.index);
  return (is_part_of_body(entry.kind) ? "bodies/" + std::to_string(entry.body) + "/" : "") + list + "/" + number;
}

OutlinerRow row_of(const Scene& scene, const SceneEntry& entry) {
  const std::string note = visit_entry(scene, entry, [](const auto& item) { return kind_note(item); });
  return {entry, tag_of(entry), entry_name(scene, entry), note, {}};
}

/// True if the row matches. Numbers that stand for names are not searched.
bool matches(const OutlinerRow& row, std::string_view filter) {
  const std::string_view name = row.name;
  return holds_text(has_name(row.entry.kind) ? name : name.substr(0, name.rfind(' ')), filter) ||
         holds_text(row.note, filter) || holds_text(row.body.state(), filter) || holds_text(row.body.mark(), filter);
}

/// Returns the body's row and those of its supports and loads: all if the body matches, else the body with the matching
/// ones.
std::vector<OutlinerRow> rows_of_body(const Scene& scene, const BodyRow& body, std::span<const SceneEntry> parts,
                                      std::string_view filter) {
  std::vector<OutlinerRow> rows = {row_of(scene, {EntryKind::body, body.scene_body})};
  rows.front().body = body;
  const bool all = matches(rows.front(), filter);
  for (const SceneEntry& entry : parts) {
    OutlinerRow row = row_of(scene, entry);
    if (all || matches(row, filter)) rows.push_back(std::move(row));
  }
  if (!all && rows.size() == 1) rows.clear();
  return rows;
}

}  // namespace

std::vector<OutlinerRow> outliner_rows(const Scene& scene, const std::vector<BodyRow>& bodies,
                                       std::string_view filter) {
  std::vector<std::vector<SceneEntry>> parts(scene.bodies.size());
  std::vector<OutlinerRow> others;
  for (const SceneEntry& entry : scene_entries(scene)) {
    if (is_part_of_body(entry.kind)) parts[static_cast<std::size_t>(entry.body)].push_back(entry);
    if (is_part_of_body(entry.kind) || entry.kind == EntryKind::body) continue;
    OutlinerRow row = row_of(scene, entry);
    if (matches(row, filter)) others.push_back(std::move(row));
  }
  std::vector<OutlinerRow> rows;
  for (const BodyRow& body : bodies)
    std::ranges::move(rows_of_body(scene, body, parts[static_cast<std::size_t>(body.scene_body)], filter),
                      std::back_inserter(rows));
  std::ranges::move(others, std::back_inserter(rows));
  return rows;
}

std::vector<OutlinerRow> outliner_piece_rows(std::vector<BodyRow> pieces, std::string_view filter) {
  filter_rows(pieces, filter);
  std::vector<OutlinerRow> rows;
  for (BodyRow& piece : pieces) {
    const std::string tag = "bodies/" + std::to_string(rows.size());
    rows.push_back({{EntryKind::body, piece.scene_body}, tag, piece.name, "", piece});
  }
  return rows;
}

}  // namespace griffith::ui
