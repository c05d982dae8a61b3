#include "ui/model/time_view.h"

#include "ui/model/units.h"

namespace griffith::ui {

std::string step_text(const TimeView& time, std::int64_t step) {
  return "step " + std::to_string(step) + ", " + format_quantity(static_cast<double>(step) * time.time_step, "s", 4);
}

}  // namespace griffith::ui
