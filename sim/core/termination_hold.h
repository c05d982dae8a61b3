#pragma once

namespace griffith {

/// While one lives, SIGINT, SIGTERM and SIGHUP do not end the program but are noted, so that temporary files can be
/// removed first. With the last of them, what was noted takes its usual course. After three signals the next one acts
/// at once: supervisors such as timeout(1) send theirs twice.
class TerminationHold {
 public:
  TerminationHold();
  ~TerminationHold();
  TerminationHold(const TerminationHold&) = delete;
  TerminationHold& operator=(const TerminationHold&) = delete;

  /// Whether the program was asked to end since the first of them.
  bool requested() const;
};

}  // namespace griffith
