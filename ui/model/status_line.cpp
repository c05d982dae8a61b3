#include "ui/model/status_line.h"

#include <algorithm>

namespace griffith::ui {
namespace {

/// Returns the first line that is still valid for that span. What was done is old once anything else was reported.
std::size_t first_valid(const EditorState& state, LogSpan span) {
  switch (span) {
    case LogSpan::lasting:
      return state.log.size() - 1;
    case LogSpan::state:
      return state.log_passed;
    case LogSpan::action:
      return std::max(state.log_passed, state.log_seen);
    case LogSpan::advice:
      return state.log_seen;
  }
  return 0;
}

}  // namespace

const LogLine* status_line(const EditorState& state) {
  for (std::size_t i = state.log.size(); i-- > 0;)
    if (i >= first_valid(state, state.log[i].span)) return &state.log[i];
  return nullptr;
}

}  // namespace griffith::ui
