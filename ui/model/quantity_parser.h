#pragma once

#include <optional>
#include <string_view>

#include "ui/model/units.h"

namespace griffith::ui {

/// Value of what is typed into a number field, in `unit` without prefix: a number, or arithmetic with + - * / and
/// parentheses: "20 GPa", "20G", "2e10", "2*30+1 mm", "(4-1) cm / 2". Numbers without a unit are in the one shown,
/// which is `unit` with the prefix `shown`, unless they multiply or divide. Nothing where the text is anything else,
/// has another kind of unit, or is not finite.
std::optional<double> parse_quantity(std::string_view text, std::string_view unit, const SiPrefix& shown = {});

}  // namespace griffith::ui
