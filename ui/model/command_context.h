#pragma once

#include <cstdint>

#include "ui/model/edit_history.h"
#include "ui/model/editor_state.h"
#include "ui/model/time_view.h"

namespace griffith::ui {

/// State on which it depends whether a command is enabled.
struct CommandContext {
  const EditorState& state;
  const EditHistory& history;
  const TimeView& time;
  std::int64_t step = 0;    ///< shown step
  bool has_legend = false;  ///< the picture has a color range
};

// Each returns the reason why a command is disabled, in a sentence; empty if it is enabled.
std::string_view nothing_to_undo(const CommandContext& context);
std::string_view nothing_to_redo(const CommandContext& context);
std::string_view no_past(const CommandContext& context);
std::string_view no_future(const CommandContext& context);
std::string_view one_branch_alone(const CommandContext& context);
std::string_view not_stopped_before_a_crack(const CommandContext& context);
std::string_view nothing_fired(const CommandContext& context);
std::string_view no_body(const CommandContext& context);
std::string_view nothing_selected(const CommandContext& context);
std::string_view nothing_to_move_up(const CommandContext& context);
std::string_view nothing_to_move_down(const CommandContext& context);
std::string_view no_region_selected(const CommandContext& context);
std::string_view nothing_with_a_name(const CommandContext& context);
std::string_view no_body_selected(const CommandContext& context);
std::string_view no_camera_selected(const CommandContext& context);
std::string_view no_recoverable_edits(const CommandContext& context);
std::string_view no_surface_named(const CommandContext& context);
std::string_view nothing_recorded(const CommandContext& context);
std::string_view nothing_plotted(const CommandContext& context);
std::string_view no_color_range(const CommandContext& context);

// Each is true if the state that a command toggles is on.
bool is_running(const CommandContext& context);
bool shows_edges(const CommandContext& context);
bool locks_range(const CommandContext& context);
bool has_slice(const CommandContext& context);
bool hides_body(const CommandContext& context);
bool shows_plots(const CommandContext& context);
bool compares(const CommandContext& context);
bool records_macro(const CommandContext& context);
bool shows_problems(const CommandContext& context);
bool shows_log(const CommandContext& context);
bool shows_gizmo(const CommandContext& context);
bool paints_regions(const CommandContext& context);
bool shows_help(const CommandContext& context);

}  // namespace griffith::ui
