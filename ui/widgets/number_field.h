#pragma once

#include <optional>
#include <string>

#include "ui/model/units.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {

/// A physical quantity that can be edited.
struct NumberField {
  std::string tag;    ///< "material/young_modulus"
  std::string label;  ///< "Young's modulus"
  Numbers numbers;    ///< accepted range and unit
  std::string tooltip = {};
  std::optional<double> original =
      {};  ///< original value, which a click on the label restores; the label is bright while the value differs
  std::optional<SiPrefix> prefix = {};  ///< prefix shared with other numbers; none: that of its value
  bool names_unit = true;               ///< false if its row names the unit
  bool whole = false;                   ///< accepts only integers
  double vector_magnitude = 0;          ///< magnitude of the largest component of its vector
  double usual = 0;                     ///< magnitude that a drag from 0 reaches in 200 pixels; 0: by the unit
};

/// Draws a number over the width of the next item. A click, Tab or a right click opens it for typing without changing
/// it. A bare number is in the shown unit; arithmetic and other units are read, see parse_quantity(). Tab and Enter
/// accept the text, Escape cancels; a rejected or clamped value leaves a note. A drag to the right or left changes the
/// value, see dragged_number(), finely with Shift, to round values with Ctrl; Escape cancels the drag. The unit stays
/// the same until the edit ends.
Edit number_field(Panel& panel, const NumberField& field, double& value);

/// Draws the number with its label, as a row.
Edit number_field_row(Panel& panel, const NumberField& field, double& value);
/// Draws a count with its label, as a row.
Edit number_field_row(Panel& panel, NumberField field, int& value);

/// Returns the prefix of the edit of a number whose tag begins with `tag`, also on the way from it to the next number.
std::optional<SiPrefix> ongoing_prefix(const EditorState& state, std::string_view tag);
/// Returns the common prefix of numbers whose largest magnitude is `largest`, or that of an ongoing edit of one of
/// them. `tag`: beginning of the tags of all of them.
SiPrefix shared_prefix(const EditorState& state, std::string_view tag, double largest, std::string_view unit);

}  // namespace griffith::ui
