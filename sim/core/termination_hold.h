#pragma once

namespace griffith {

/// Postpones SIGINT, SIGTERM and SIGHUP during its lifetime, so that temporary files can be removed first. When the
/// last hold ends, the last signal takes its usual effect. After three signals the next one acts at once, since
/// supervisors such as timeout(1) send theirs twice.
class TerminationHold {
 public:
  TerminationHold();
  ~TerminationHold();
  TerminationHold(const TerminationHold&) = delete;
  TerminationHold& operator=(const TerminationHold&) = delete;

  /// True if the program was asked to end since the first hold began.
  bool requested() const;
};

}  // namespace griffith
