#pragma once

#include <atomic>
#include <future>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "app/editor/holding.h"

namespace griffith::app {

/// Changes with which a cracking node would have held.
struct HoldingAnswer {
  CriticalFactor strength;  ///< factor on the strength in the next step
  StepCracks broken, held;  ///< cracks of that step as it is, and with the strength that holds
  std::optional<CriticalFactor> speed,
      thickness;           ///< factors in the run; none: nothing moves, no thickness, or not tried
  std::string problem;     ///< reason why the search ended early; empty: none
  bool cancelled = false;  ///< true if it was cancelled early
};

/// Searches the changes that would have held a node, on a thread of its own. The destructor cancels it.
class HoldingSearch {
 public:
  /// `timeline`: in the state just before the node cracks; it is copied.
  HoldingSearch(const Timeline& timeline, NodeId node);
  ~HoldingSearch() { cancel(); }

  /// Ends the search at its next step; the answer contains what was found by then.
  void cancel() { cancelled_ = true; }
  /// Describes the current trial: "Trying 0.36 times the speed".
  std::string stage() const;
  /// Returns the answer once it is ready.
  std::optional<HoldingAnswer> take();

  const RunToCrack& run() const { return run_; }

 private:
  HoldingAnswer search(const World& before);
  void enter(std::string_view stage);

  RunToCrack run_;
  std::atomic<bool> cancelled_ = false;
  mutable std::mutex mutex_;
  std::string stage_;                  ///< under `mutex_`
  std::future<HoldingAnswer> answer_;  ///< ends before the data of its thread
};

}  // namespace griffith::app
