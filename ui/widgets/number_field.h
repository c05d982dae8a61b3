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
  Numbers numbers;    ///< what a scene takes, in which unit
  std::string tooltip = {};
  std::optional<double> original = {};  ///< a click on the label brings it back, which is bright while there is another
  std::optional<SiPrefix> prefix = {};  ///< that it has together with others; none: that of its value
  bool names_unit = true;               ///< false: its row does
  bool whole = false;                   ///< only integers
  double beside = 0;                    ///< magnitude of the largest component of its vector
  double usual = 0;                     ///< magnitude that a drag away from 0 reaches in 200 pixels; 0: by the unit
};

/// A number over the width of the next item. A click, Tab or a right click opens it for typing and never changes it: a
/// bare number is in the unit shown, arithmetic and other units are read (see parse_quantity()). Tab and Enter take
/// what was typed, Escape does not; what is not taken as it was typed leaves a note. A drag to the right or left
/// changes it (see dragged_number()), with Shift finely, with Ctrl to round values; Escape takes the drag back. The
/// unit stays the same until the edit ends.
Edit number_field(Panel& panel, const NumberField& field, double& value);

/// The same with its label, as a row.
Edit number_field_row(Panel& panel, const NumberField& field, double& value);
/// A count with its label, as a row.
Edit number_field_row(Panel& panel, NumberField field, int& value);

/// The prefix for numbers that are shown in one unit, the largest of which has that magnitude: the one of the edit,
/// while one of them is edited. `tag`: what all their tags are or begin with.
SiPrefix shared_prefix(const EditorState& state, std::string_view tag, double largest, std::string_view unit);

}  // namespace griffith::ui
