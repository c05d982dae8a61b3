#include "sim/recording/replay.h"

#include "sim/recording/assets.h"
#include "sim/timeline/timeline.h"

namespace griffith {
namespace {

/// Returns the recording's scene with its files in the folder.
Scene unpacked_scene(const Recording& recording, const std::filesystem::path& folder) {
  write_files(recording.assets, folder);
  Scene scene = recording.scene;
  scene.folder = folder;
  return scene;
}

/// Returns a monitor that also cancels when the program is asked to end.
Monitor ending_with(const TemporaryFolder& folder, const Monitor& monitor) {
  return {monitor.stage, [&] { return folder.termination_requested() || monitor.is_cancelled(); }};
}

}  // namespace

Replay::Replay(const Recording& recording, const Monitor& monitor)
    : recording_(recording),
      scene_(unpacked_scene(recording, folder_.path())),
      world_(scene_, filled_surfaces(scene_), ending_with(folder_, monitor)) {
  compare();
  do_inputs();
}

void Replay::advance() {
  if (folder_.termination_requested()) throw Cancelled();
  world_.step();
  compare();
  do_inputs();
}

void Replay::compare() {
  if (difference_) return;
  const std::int64_t step = world_.frame().step;
  const StateHashes hashes = world_.state_hashes(), recorded = recording_.hashes[static_cast<std::size_t>(step)];
  if (hashes == recorded) return;
  difference_ = ReplayDifference{step, {}};
  for (std::size_t i = 0; i < hashes.size(); ++i)
    if (hashes[i] != recorded[i]) difference_->fields.push_back(kStateFields[i]);
}

/// Applies the inputs between this step and the next.
void Replay::do_inputs() {
  const std::vector<WorldInput>& inputs = recording_.inputs;
  for (; inputs_done_ < inputs.size() && inputs[inputs_done_].step <= world_.frame().step; ++inputs_done_) {
    WorldInput input = inputs[inputs_done_];
    apply(world_, input);
  }
}

}  // namespace griffith
