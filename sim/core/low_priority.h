#pragma once

#include <memory>

namespace griffith {

/// Lowers the priority of a thread that works in the background, and of the workers of its parallel loops, so that a
/// window answers while all processors are busy. Threads keep the priority: systems let it be lowered, but not raised.
/// Results do not depend on it. Has an effect on Linux alone.
class LowPriority {
 public:
  /// For the calling thread.
  LowPriority();
  ~LowPriority();
  LowPriority(const LowPriority&) = delete;
  LowPriority& operator=(const LowPriority&) = delete;

 private:
  class Workers;
  std::unique_ptr<Workers> workers_;
};

}  // namespace griffith
