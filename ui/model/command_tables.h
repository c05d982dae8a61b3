#pragma once

#include <span>

#include "ui/model/commands.h"

namespace griffith::ui {

// The parts of the registry, which a new command is added to: in the order of the menus and of their entries.

/// Files, edits, and what is added to a scene.
std::span<const CommandInfo> scene_commands();
/// Simulation, view and help, and what widgets and scripts alone issue.
std::span<const CommandInfo> run_commands();

}  // namespace griffith::ui
