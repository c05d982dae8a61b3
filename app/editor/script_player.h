#pragma once

#include <filesystem>
#include <optional>

#include "app/editor/editor.h"
#include "app/editor/script.h"
#include "ui/model/input_queue.h"

namespace griffith::app {

/// Plays a script in the editor, a line at a time: the next begins when the frames that the last one needs are drawn
/// and nothing is being built.
class ScriptPlayer {
 public:
  /// `for_reader`: what is said stays until the reader goes on.
  ScriptPlayer(Script script, bool for_reader) : script_(std::move(script)), for_reader_(for_reader) {}

  /// To be called before each frame, whose input comes from `input`. Throws InputError where a line cannot be played or
  /// expects something else than is shown.
  void advance(Editor& editor, ui::InputQueue& input);
  bool done() const { return next_ >= script_.size() && frames_left_ == 0; }
  /// Where the picture of the frame that was just drawn is wanted, once.
  std::optional<std::filesystem::path> take_picture_request();

 private:
  void play(const ScriptLine& line, Editor& editor, ui::InputQueue& input);
  /// Has the lines of a script that a line has called played next. `place`: of that line.
  void insert(const Script& called, const std::string& place);
  /// Whether the reader has not yet gone on from what is said; who has had enough ends the script.
  bool waits_for_reader(Editor& editor);

  Script script_;
  std::size_t next_ = 0;
  bool for_reader_;
  int frames_left_ = 0;  ///< until the next line
  int macros_played_ = 0;
  std::optional<std::filesystem::path> wanted_picture_;
};

}  // namespace griffith::app
