#pragma once

#include <functional>
#include <stdexcept>
#include <string_view>

namespace griffith {

/// How long work tells how far it is, and learns that nobody wants it any more. Both may be empty. `stage` is called
/// from the thread that does the work, `cancelled` from several at once.
struct Monitor {
  std::function<void(std::string_view stage)> stage;  ///< "Refining mesh"
  std::function<bool()> cancelled;

  void enter(std::string_view name) const {
    if (stage) stage(name);
  }
  bool is_cancelled() const { return cancelled && cancelled(); }
};

/// Long work was given up because the user asked for it.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

}  // namespace griffith
