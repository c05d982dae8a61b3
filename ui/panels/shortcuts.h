#pragma once

#include "ui/widgets/panel.h"

namespace griffith::ui {

/// Issues the commands whose shortcuts were pressed, unless text is being typed.
void issue_shortcuts(Panel& panel);

}  // namespace griffith::ui
