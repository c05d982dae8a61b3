#pragma once

#include <optional>
#include <string_view>

#include "ui/model/units.h"

namespace griffith::ui {

/// Parses the text of a number field into a value in `unit` without prefix. Accepts a number or arithmetic with + - * /
/// and parentheses: "20 GPa", "20G", "2e10", "2*30+1 mm", "(4-1) cm / 2". A single unit at the end is that of all
/// numbers: "1/2 + 1 m" is 1.5 m. Else those without a unit are in the shown one, `unit` with the prefix `shown`,
/// unless they multiply or divide. Empty if the text is anything else, has another kind of unit, or is not finite.
std::optional<double> parse_quantity(std::string_view text, std::string_view unit, const SiPrefix& shown = {});

}  // namespace griffith::ui
