#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/widgets/labels.h"
#include "ui/widgets/legend.h"
#include "ui/widgets/widget_tags.h"

namespace griffith::app {

/// Returns the text over a picture, one line each: "legend Utilization 0 to 1.2", "label 0.512 0.250 B 3".
std::string writing_text(const std::optional<ui::Legend>& legend, const std::vector<ui::PictureLabel>& labels);

/// Returns the widgets in drawing order, one line each: name, value, "disabled", left, top, width and height [pixels].
std::string widget_text(const ui::WidgetTags& tags);

}  // namespace griffith::app
