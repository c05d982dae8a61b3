#pragma once

#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "sim/world/world.h"

namespace griffith::app {

/// Builds worlds on a thread of its own, one at a time, so that the window goes on living while a surface is meshed.
class WorldLoader {
 public:
  struct Loaded {
    Scene scene;
    std::filesystem::path path;
    World world;
  };

  /// Gives up what is being built, and waits for that.
  ~WorldLoader() { cancel(); }

  /// Starts to build the world of a scene from the file `path`; what was being built before is given up.
  void start(Scene scene, std::filesystem::path path);
  /// The same for a scene that takes work itself.
  using MakeScene = std::function<Scene(const Monitor&)>;
  void start(MakeScene make_scene, std::filesystem::path path);
  /// Waits for `seconds` at most; whether the result is there to be taken.
  bool wait(double seconds) const;
  /// The world, once it is built; nothing while there is none. Throws the InputError that kept it from being built.
  std::optional<Loaded> take();
  /// What is being done; empty when nothing is.
  std::string stage() const;
  /// Gives up what is being built, and waits for that.
  void cancel();

 private:
  /// What both threads see.
  struct Shared {
    std::mutex mutex;
    std::string stage;       ///< under `mutex`
    bool cancelled = false;  ///< under `mutex`
  };

  std::shared_ptr<Shared> shared_;
  std::future<Loaded> result_;
};

}  // namespace griffith::app
