#pragma once

#include <functional>
#include <stdexcept>
#include <string_view>

namespace griffith {

/// Callbacks through which long work reports its stage and learns that it is cancelled. Both may be empty. `stage` is
/// called on the thread that does the work, `cancelled` on several at once.
struct Monitor {
  std::function<void(std::string_view stage)> stage;  ///< gets, for example, "Refining mesh"
  std::function<bool()> cancelled;

  void enter(std::string_view name) const {
    if (stage) stage(name);
  }
  bool is_cancelled() const { return cancelled && cancelled(); }
};

/// Long work ended early at the user's request.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

}  // namespace griffith
