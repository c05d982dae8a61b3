#pragma once

#include <atomic>
#include <future>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "app/editor/holding.h"

namespace griffith::app {

/// With what a node would have stood that is about to crack.
struct HoldingAnswer {
  HoldingFactor strength;                            ///< how many times as strong, for the next step
  std::optional<HoldingFactor> slowness, thickness;  ///< for the run; none: nothing flies, no thickness, or not tried
  std::string problem;                               ///< why no more could be tried; empty: none
  bool cancelled = false;                            ///< before all was tried
};

/// Looks for what would have held a node, on a thread of its own. Destroying it gives up.
class HoldingSearch {
 public:
  /// `timeline`: stands just before the node cracks; it is copied.
  HoldingSearch(const Timeline& timeline, NodeId node);
  ~HoldingSearch() { cancel(); }

  /// Ends the search at its next step: the answer tells what was found by then.
  void cancel() { cancelled_ = true; }
  /// What is being tried: "Trying 0.36 times the speed".
  std::string stage() const;
  /// The answer, once it is there.
  std::optional<HoldingAnswer> take();

  const RunToCrack& run() const { return run_; }

 private:
  HoldingAnswer search(const World& before);
  void enter(std::string_view stage);

  RunToCrack run_;
  std::atomic<bool> cancelled_ = false;
  mutable std::mutex mutex_;
  std::string stage_;                  ///< under `mutex_`
  std::future<HoldingAnswer> answer_;  ///< ends before what its thread sees
};

}  // namespace griffith::app
