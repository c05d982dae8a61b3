#pragma once

#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "app/draw_scene_from_frame.h"
#include "sim/world/world.h"

namespace griffith::app {

/// What a world is built for.
enum class Work { open, recover, add_body, follow };

/// Builds worlds on a thread of its own, one at a time, so that the window goes on living while a surface is meshed.
class WorldLoader {
 public:
  struct Loaded {
    Work work = Work::open;
    Scene scene;
    std::filesystem::path path;
    World world;
    EmbeddedDisplay display;
  };

  /// Gives up what is being built, and waits for that.
  ~WorldLoader() { cancel(); }

  /// Starts to build the world of a scene from the file `path`; what was being built before is given up.
  void start(Work work, Scene scene, std::filesystem::path path);
  /// The same for a scene that takes work itself.
  using MakeScene = std::function<Scene(const Monitor&)>;
  void start(Work work, MakeScene make_scene, std::filesystem::path path);
  /// Waits for `seconds` at most; whether the result is there to be taken.
  bool wait(double seconds) const;
  /// The world, once it is built; nothing while there is none. Throws the InputError that kept it from being built.
  std::optional<Loaded> take();
  /// What the world that was started last is for.
  Work work() const { return work_; }
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

  Work work_ = Work::open;
  std::shared_ptr<Shared> shared_;
  std::future<Loaded> result_;
};

}  // namespace griffith::app
