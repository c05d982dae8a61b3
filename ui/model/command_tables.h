#pragma once

#include <span>

#include "ui/model/commands.h"

namespace griffith::ui {

// The parts of the command registry, in the order of the menus and their entries.

/// Commands for files, edits and adding to a scene.
std::span<const CommandInfo> scene_commands();
/// Commands for simulation, view and help, and those without a menu.
std::span<const CommandInfo> run_commands();

}  // namespace griffith::ui
