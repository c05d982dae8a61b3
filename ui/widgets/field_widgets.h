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

/// Tag and texts of a field of the scene.
struct FieldRow {
  std::string tag;          ///< "body/position"
  std::string label;        ///< "Position"
  std::string description;  ///< text of the tooltip
};

/// Replaces underscores: "point_force" becomes "point force", or "Point force" as a label.
std::string words_of(std::string_view name);
std::string label_of(std::string_view name);

// Each draws a row. The result is within the accepted range even if the given value is not.

Edit draw_field(Panel& panel, const FieldRow& row, const Numbers& numbers, double& value);
Edit draw_field(Panel& panel, const FieldRow& row, const Numbers& numbers, int& value);
/// Draws the components side by side, each as a number; the label names their common unit, which has that prefix.
Edit draw_field(Panel& panel, const FieldRow& row, const Numbers& numbers, std::span<double> components,
                const SiPrefix& prefix);
/// Draws integers separated by commas.
Edit draw_field(Panel& panel, const FieldRow& row, const Numbers& numbers, std::vector<int>& values);
Edit draw_field(Panel& panel, const FieldRow& row, Flag, bool& value);
Edit draw_field(Panel& panel, const FieldRow& row, const Text& text, std::string& value);
/// Draws a file name, accepted with Enter if the file exists; relative paths start at `folder`.
Edit draw_field(Panel& panel, const FieldRow& row, const std::filesystem::path& folder, std::filesystem::path& value);
/// Draws a list. `value`: index of the name.
Edit draw_choice(Panel& panel, const FieldRow& row, const OneOf& one_of, int& value);
/// Draws a check box for each of the names. `chosen`: indices of the checked ones, in their order.
Edit draw_choices(Panel& panel, const FieldRow& row, const OneOf& one_of, std::vector<int>& chosen);
/// Draws a check box "on" for an optional part.
Edit draw_presence(Panel& panel, const FieldRow& row, bool& present);

/// Begins a foldable section with fields of its own, tagged. If true, close it with end_part().
bool begin_part(Panel& panel, const FieldRow& row, const std::string& summary);
void end_part();

}  // namespace griffith::ui
