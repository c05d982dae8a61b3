#include "ui/model/status_line.h"

#include <gtest/gtest.h>

namespace griffith::ui {
namespace {

std::string shown(const EditorState& state) {
  const LogLine* line = status_line(state);
  return line ? line->text : "nothing";
}

TEST(StatusLine, IsTheNewestThatIsStillTrue) {
  EditorState state;
  EXPECT_EQ(shown(state), "nothing");
  state.log = {{LogLevel::info, "saved"},
               {LogLevel::warning, "stopped", LogSpan::state},
               {LogLevel::warning, "nothing to undo", LogSpan::action}};
  EXPECT_EQ(shown(state), "nothing to undo");
  state.log_seen = 3;  // the user did something else
  EXPECT_EQ(shown(state), "stopped");
  state.log_passed = 3;  // the simulation went on
  EXPECT_EQ(shown(state), "nothing") << "what was done before is no news";
  state.log.push_back({LogLevel::info, "fired", LogSpan::action});
  EXPECT_EQ(shown(state), "fired");
  state.log_passed = 4;
  EXPECT_EQ(shown(state), "nothing");
  state.log.push_back({LogLevel::info, "press Space", LogSpan::advice});
  state.log_passed = 5;
  EXPECT_EQ(shown(state), "press Space");
  state.log_seen = 5;
  EXPECT_EQ(shown(state), "nothing");
  state.log.push_back({LogLevel::info, "saved again"});
  state.log_seen = state.log_passed = 6;
  EXPECT_EQ(shown(state), "saved again");
}

}  // namespace
}  // namespace griffith::ui
