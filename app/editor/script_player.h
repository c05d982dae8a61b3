#pragma once

#include <filesystem>
#include <optional>

#include "app/editor/editor.h"
#include "app/editor/script.h"
#include "ui/model/input_queue.h"

namespace griffith::app {

/// Plays a script in the editor line by line. The next line begins when the frames of the last one are drawn and
/// nothing is being built.
class ScriptPlayer {
 public:
  /// `for_reader`: captions stay until the user continues.
  ScriptPlayer(Script script, bool for_reader) : script_(std::move(script)), for_reader_(for_reader) {}

  /// Plays the next lines; call it before each frame, with its `input`. Throws InputError if a line cannot be played or
  /// its expectation fails.
  void advance(Editor& editor, ui::InputQueue& input);
  bool done() const { return next_ >= script_.size() && frames_left_ == 0; }
  /// Returns the requested file for a picture of the frame just drawn, once.
  std::optional<std::filesystem::path> take_picture_request();

 private:
  void play(const ScriptLine& line, Editor& editor, ui::InputQueue& input);
  /// Inserts the lines of a called script. `place`: of the calling line.
  void insert(const Script& called, const std::string& place);
  /// True if the user has not yet continued; a user who skips ends the script.
  bool waits_for_reader(Editor& editor);

  Script script_;
  std::size_t next_ = 0;
  bool for_reader_;
  int frames_left_ = 0;  ///< frames until the next line
  int macros_played_ = 0;
  std::optional<std::filesystem::path> requested_picture_;
};

}  // namespace griffith::app
