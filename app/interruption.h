#pragma once

namespace griffith::app {

/// While it lives, Ctrl-C does not end the program but is noted, so that long work can stop in good order. After
/// three of them the next one ends the program as usual. One at a time.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  bool requested() const;
};

}  // namespace griffith::app
