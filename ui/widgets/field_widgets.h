#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/scene/field.h"
#include "ui/model/units.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {

/// Where a field of the scene is shown, and what it means.
struct FieldRow {
  std::string tag;          ///< "body/position"
  std::string label;        ///< "Position"
  std::string description;  ///< for the tooltip
};

/// "point_force" as "point force", and as the label "Point force".
std::string words_of(std::string_view name);
std::string label_of(std::string_view name);

// A row each. They keep values within what the field takes; what they are given may lie beyond.

Edit draw_field(Panel& panel, const FieldRow& row, const Numbers& numbers, double& value);
Edit draw_field(Panel& panel, const FieldRow& row, const Numbers& numbers, int& value);
/// The components side by side, each as a number; the label names the unit of all, which has that prefix.
Edit draw_field(Panel& panel, const FieldRow& row, const Numbers& numbers, std::span<double> components,
                const SiPrefix& prefix);
/// Whole numbers between commas.
Edit draw_field(Panel& panel, const FieldRow& row, const Numbers& numbers, std::vector<int>& values);
Edit draw_field(Panel& panel, const FieldRow& row, Flag, bool& value);
Edit draw_field(Panel& panel, const FieldRow& row, const Text& text, std::string& value);
/// Taken with Enter, if the file exists; relative paths start at `folder`.
Edit draw_field(Panel& panel, const FieldRow& row, const std::filesystem::path& folder, std::filesystem::path& value);
/// `value`: which of the names.
Edit draw_choice(Panel& panel, const FieldRow& row, const OneOf& one_of, int& value);
/// A check box for each of the names; `chosen`: which are checked, in the order in which they were.
Edit draw_choices(Panel& panel, const FieldRow& row, const OneOf& one_of, std::vector<int>& chosen);
/// A check box "on" for what may be absent.
Edit draw_presence(Panel& panel, const FieldRow& row, bool& present);

/// Opens a part with fields of its own, tagged; to be closed by end_part() when it says true.
bool begin_part(Panel& panel, const FieldRow& row, const std::string& summary);
void end_part();

}  // namespace griffith::ui
