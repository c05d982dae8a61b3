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

/// Purpose of a build.
enum class LoadReason { open, recover, add_body, follow };

/// A requested mesh that is so large that it may be a mistake.
struct LargeMesh : std::exception {
  explicit LargeMesh(double expected) : tets(expected) {}
  double tets;
};

/// A world with the data that the editor shows with it.
struct BuiltWorld {
  Scene scene;
  World world;
  EmbeddedDisplay display;
  std::vector<InputError> warnings;         ///< from scene_warnings()
  std::filesystem::file_time_type started;  ///< time before any file was read
};
/// Builds the world of a scene from the file `path`, with progress on the terminal. Throws InputError.
BuiltWorld build_world(Scene scene, const std::filesystem::path& path);

/// Builds worlds on a thread of its own, one at a time, so that the window stays responsive while a surface is meshed.
class WorldLoader {
 public:
  struct Loaded : BuiltWorld {
    LoadReason reason = LoadReason::open;
    std::filesystem::path path;
  };

  /// Cancels the build and waits for its threads.
  ~WorldLoader() { cancel(); }

  /// Begins to build the world of a scene from the file `path`, replacing any build in progress. If more than about
  /// `max_tets` tetrahedra would be made, take() throws LargeMesh before any is.
  void start(LoadReason reason, Scene scene, std::filesystem::path path, double max_tets);
  /// Begins with a function that makes the scene, for scenes that take long to make.
  using MakeScene = std::function<Scene(const Monitor&)>;
  void start(LoadReason reason, MakeScene make_scene, std::filesystem::path path, double max_tets);
  /// Restarts the last build without a limit of size.
  void start_again();
  /// Waits at most `seconds`. True if the result is ready.
  bool wait(double seconds) const;
  /// Returns the world once it is built; empty before. Throws the InputError of the build, or LargeMesh.
  std::optional<Loaded> take();
  /// Returns the purpose of the last build.
  LoadReason reason() const { return order_.reason; }
  /// Describes the progress; empty if nothing is being built.
  std::string stage() const;
  /// Cancels the build. Returns at once: its thread ends by itself at its next check.
  void cancel();

 private:
  /// Data shared by both threads.
  struct Shared {
    std::mutex mutex;
    std::string stage;       ///< under `mutex`
    bool cancelled = false;  ///< under `mutex`
  };

  /// A requested build.
  struct Order {
    LoadReason reason = LoadReason::open;
    MakeScene make_scene;
    std::filesystem::path path;
    double max_tets = 0;
    KnownShards known;  ///< shards of the last world, for bodies that stay as they are
  };
  static Loaded build(const Order& order, const std::shared_ptr<Shared>& shared);

  Order order_;
  std::shared_ptr<Shared> shared_;
  std::future<Loaded> result_;
  std::vector<std::future<Loaded>> cancelled_;  ///< builds whose threads have not ended yet
};

}  // namespace griffith::app
