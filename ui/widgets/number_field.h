#pragma once

#include <optional>
#include <string>

#include "ui/model/units.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {

/// A physical quantity as an editable field.
struct NumberField {
  std::string tag;    ///< "material/young_modulus"
  std::string label;  ///< "Young's modulus"
  Numbers numbers;    ///< range and unit
  std::string tooltip = {};
  double low = numbers.minimum, high = numbers.maximum;  ///< ends of the bar that shows how high the value is
  bool logarithmic = false;             ///< a drag multiplies, and the bar shows orders of magnitude; needs low > 0
  bool whole = false;                   ///< takes whole numbers alone
  std::optional<double> original = {};  ///< a click on the label restores it; the label is bright while it differs
  std::optional<SiPrefix> prefix = {};  ///< of a row of several numbers, whose label says the unit; none: its own
};

// One kind of field for all numbers of the editor, which behaves as those of Blender do.
//
//   click         opens it for typing, with all of its text selected; the value stays
//   drag          changes the value relatively: 0.5 % a pixel where it is logarithmic, else a step that fits its size.
//                 Shift makes it ten times finer, Ctrl ten times coarser and rounds
//   typing        a number, a unit, arithmetic: "20 GPa", "2*30 + 1 mm". A bare number is in the unit that the field
//                 shows, which stays until typing or dragging ends
//   Enter, click elsewhere    takes what was typed; what cannot be read leaves a note, and the value stays
//   Tab, Shift+Tab            takes it and opens the next or last field
//   Escape        leaves the value as it was, also in a drag
//   wheel         scrolls the panel, and never changes a value

/// A row: label and field.
Edit quantity_row(Panel& panel, const NumberField& field, double& value);
/// The field alone, as wide as the next item.
Edit quantity_box(Panel& panel, const NumberField& field, double& value);
/// A row for a whole number.
Edit integer_row(Panel& panel, const char* tag, const char* label, int& value, const Numbers& numbers,
                 const std::string& tooltip = {});

/// What a drag of `way` pixels makes of the value that it began at; within the field's range.
double dragged_value(const NumberField& field, double start, double way, bool rounded);

}  // namespace griffith::ui
