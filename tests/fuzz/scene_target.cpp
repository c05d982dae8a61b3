#include "sim/scene/scene_reader.h"
#include "sim/scene/scene_writer.h"
#include "tests/fuzz/mutate_json.h"
#include "tests/fuzz/small_scenes.h"
#include "tests/fuzz/target.h"
#include "tests/fuzz/world_checks.h"

namespace griffith::fuzz {
namespace {

class SceneTarget : public Target {
 public:
  std::string name() const override { return "scene"; }
  int fraction() const override { return 330; }

  Input make(RandomValues& random) const override {
    const Json& scene = pick(random, scenes_);
    const Json& donor = pick(random, scenes_);
    Input input{"input.json", {{"input.json", mutate_scene(scene, donor, words_, random)}}};
    for (const auto& [name, content] : small_files())
      if (input.files["input.json"].find(name) != std::string::npos) input.files[name] = content;
    return input;
  }

  Outcome run(const Input& input, const std::filesystem::path& folder) const override {
    const std::string& text = input.files.at(input.entry);
    const Scene scene = scene_from_json(text, "scene", folder);
    promise(check_scene_text(text, "scene").empty(), "a scene that can be read has problems");
    write_and_read(scene);
    if (work_of(scene) > kMaxWork) return Outcome::too_large;
    run_world(made_quick(scene), kMaxSteps);
    return Outcome::ran;
  }

 private:
  /// The file's own materials grow by those of bodies.
  static void write_and_read(Scene scene) {
    const std::string text = scene_to_json(scene);
    const Scene back = scene_from_json(text, "scene", scene.folder);
    scene.materials = back.materials;
    promise(back == scene, "written and read, it is another scene");
    promise(scene_to_json(back) == text, "written again, it is another text");
  }

  static constexpr double kMaxWork = 4000;  ///< tets, splinters, projectiles
  static constexpr int kMaxSteps = 6;
  std::vector<Json> scenes_ = small_scenes();
  Vocabulary words_ = scene_vocabulary();
};

}  // namespace

std::unique_ptr<Target> make_scene_target() { return std::make_unique<SceneTarget>(); }

}  // namespace griffith::fuzz
