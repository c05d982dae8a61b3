#pragma once

#include <cstdint>
#include <string_view>

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
  int microsteps = 0;       ///< number of microsteps of the last step
};

}  // namespace griffith::ui
