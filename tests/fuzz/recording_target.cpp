#include <iterator>

#include "sim/core/parallel.h"
#include "sim/core/temporary_folder.h"
#include "sim/recording/recording.h"
#include "sim/recording/replay.h"
#include "tests/fuzz/mutate_bytes.h"
#include "tests/fuzz/mutate_json.h"
#include "tests/fuzz/small_scenes.h"
#include "tests/fuzz/target.h"

namespace griffith::fuzz {
namespace {

/// A body of a mesh file that falls.
Scene falling_mesh(const std::filesystem::path& folder) {
  Scene scene;
  scene.folder = folder;
  scene.bodies.resize(1);
  scene.bodies[0].shape = MeshFileShape{"box.msh"};
  scene.bodies[0].position = Vec3(0, 0.6, 0);
  return scene;
}

/// Four steps, a shot and a change of material.
Recording small_recording() {
  const ThreadLimit one(1);  // processes are forked later: they inherit no workers
  const TemporaryFolder folder;
  write_input({"box.msh", {{"box.msh", small_files().at("box.msh")}}}, folder.path());
  World world(falling_mesh(folder.path()));
  Recording recording = begin_recording(world);
  for (int step = 0; step < 4; ++step) {
    world.step();
    recording.hashes.push_back(world.state_hashes());
  }
  recording.inputs = {{1, ProjectileBurst()}, {3, MaterialChange{0, Material()}}};
  return recording;
}

/// Runs that somebody else recorded.
class RecordingTarget : public Target {
 public:
  std::string name() const override { return "recording"; }
  int fraction() const override { return 30; }

  Input make(RandomValues& random) const override {
    std::string archive;
    if (chance(random, 0.2)) {
      archive = mutate_bytes(pack_files(files_, "recording"), random);
    } else {
      archive = pack_files(with_damaged_file(random), "recording");
    }
    return {"input.tar.zst", {{"input.tar.zst", archive}}};
  }

  Outcome run(const Input& input, const std::filesystem::path& folder) const override {
    Recording recording = read_recording(folder / input.entry);
    const auto copy = folder / "copy.tar.zst";
    write_recording(recording, copy);
    promise(files_of(read_recording(copy)) == files_of(recording), "written and read, it is another recording");
    if (work_of(recording.scene) > kMaxWork) return Outcome::too_large;
    recording.scene = made_quick(recording.scene);
    Replay replay(recording);
    for (int step = 0; step < kMaxSteps && !replay.at_end(); ++step) replay.advance();
    return Outcome::ran;
  }

 private:
  static constexpr double kMaxWork = 1000;  ///< tets, splinters, projectiles
  static constexpr int kMaxSteps = 6;

  FileTree with_damaged_file(RandomValues& random) const {
    FileTree files = files_;
    auto file = files.begin();
    std::advance(file, random.index(static_cast<int>(files.size())));
    if (file->first == "scene.json") {
      const Json scene = Json::parse(file->second);
      file->second = mutate_scene(scene, pick(random, scenes_), words_, random);
    } else if (chance(random, 0.1)) {
      files.erase(file);
    } else {
      file->second = mutate_file(file->second, random);
    }
    return files;
  }

  FileTree files_ = files_of(small_recording());
  std::vector<Json> scenes_ = small_scenes();
  Vocabulary words_ = scene_vocabulary();
};

}  // namespace

std::unique_ptr<Target> make_recording_target() { return std::make_unique<RecordingTarget>(); }

}  // namespace griffith::fuzz
