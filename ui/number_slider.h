#pragma once

#include <string>

#include "ui/widgets.h"

namespace griffith::ui {

/// A physical quantity as an editable row.
struct NumberField {
  const char* tag;           ///< "material/young_modulus"
  const char* label;         ///< "Young's modulus"
  const char* unit;          ///< without prefix: "Pa"
  double minimum, maximum;   ///< both are possible values
  bool logarithmic = false;  ///< equal distances are equal ratios; needs minimum > 0
  const char* tooltip = "";
  bool hide_unit = false;  ///< until it is typed into: there is no room
};

/// A slider with unit and SI prefix. Drag it, or right-click (Ctrl+click) to type a value: a bare number counts in the
/// unit shown, "20 GPa" or "2e10 Pa" in its own. Values are kept within the field's bounds.
Edit number_slider(Panel& panel, const NumberField& field, double& value);

/// The same without label, and without an end in sight: dragging changes the value by a share of itself.
Edit number_drag(Panel& panel, const NumberField& field, double& value);

}  // namespace griffith::ui
