#pragma once

#include <exception>
#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/picture/draw_scene_from_frame.h"
#include "sim/world/world.h"

namespace griffith::app {

/// What a world is built for.
enum class LoadReason { open, recover, add_body, follow };

/// The mesh that is asked for is so large that it may be a slip.
struct LargeMesh : std::exception {
  explicit LargeMesh(double expected) : tets(expected) {}
  double tets;
};

/// Builds worlds on a thread of its own, one at a time, so that the window goes on living while a surface is meshed.
class WorldLoader {
 public:
  struct Loaded {
    LoadReason reason = LoadReason::open;
    Scene scene;
    std::filesystem::path path;
    World world;
    EmbeddedDisplay display;
    std::vector<InputError> warnings;         ///< as scene_warnings() has them
    std::filesystem::file_time_type started;  ///< before any file was read
  };

  /// Gives up what is being built, and waits for that.
  ~WorldLoader() { cancel(); }

  /// Starts to build the world of a scene from the file `path`; what was being built before is given up. Where about
  /// more than `max_tets` tetrahedra would be made, take() throws LargeMesh before any is.
  void start(LoadReason reason, Scene scene, std::filesystem::path path, double max_tets);
  /// Starts with a scene that takes work itself.
  using MakeScene = std::function<Scene(const Monitor&)>;
  void start(LoadReason reason, MakeScene make_scene, std::filesystem::path path, double max_tets);
  /// Starts what was started last again, however large it is.
  void start_again();
  /// Waits for `seconds` at most; whether the result is there to be taken.
  bool wait(double seconds) const;
  /// The world, once it is built; nothing while there is none. Throws the InputError that kept it from being built, or
  /// LargeMesh.
  std::optional<Loaded> take();
  /// What the world that was started last is for.
  LoadReason reason() const { return order_.reason; }
  /// What is being done; empty when nothing is.
  std::string stage() const;
  /// Gives up what is being built. Returns at once: its thread ends by itself when it next asks.
  void cancel();

 private:
  /// What both threads see.
  struct Shared {
    std::mutex mutex;
    std::string stage;       ///< under `mutex`
    bool cancelled = false;  ///< under `mutex`
  };

  /// What is to be built.
  struct Order {
    LoadReason reason = LoadReason::open;
    MakeScene make_scene;
    std::filesystem::path path;
    double max_tets = 0;
  };
  static Loaded build(const Order& order, const std::shared_ptr<Shared>& shared);

  Order order_;
  std::shared_ptr<Shared> shared_;
  std::future<Loaded> result_;
  std::vector<std::future<Loaded>> given_up_;  ///< whose threads have not ended yet
};

}  // namespace griffith::app
