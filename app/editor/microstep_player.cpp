#include "app/editor/microstep_player.h"

#include <algorithm>
#include <utility>

#include "sim/core/monitor.h"

namespace griffith::app {
namespace {

ui::MicrostepView view_of(const RecordedStep& recorded, std::size_t memory_limit) {
  const Frame before = recorded.before.world.frame();
  ui::MicrostepView view{.step = before.step + 1,
                         .microsteps = recorded.recording.microsteps(),
                         .interval = recorded.recording.interval(),
                         .moments = {},
                         .memory = recorded.recording.memory_used(),
                         .memory_limit = memory_limit};
  for (const MicrostepRecording::Moment& moment : recorded.recording.moments()) {
    const Frame frame = moment.world.frame();
    view.moments.push_back({moment.microstep, frame.time - before.time,
                            static_cast<int>(frame.crack_events.size() - before.crack_events.size())});
  }
  return view;
}

}  // namespace

std::size_t MicrostepPlayer::memory() const {
  constexpr double kMegabyte = 1 << 20;
  return static_cast<std::size_t>(state_.preferences.microstep_memory * kMegabyte);
}

void MicrostepPlayer::record(NextStep step) {
  sought_ = 0;
  begin(std::move(step), std::nullopt);
}

void MicrostepPlayer::begin(NextStep step, const std::optional<MicrostepRange>& range) {
  if (state_.microsteps) state_.microsteps->playing = false;
  job_ = std::make_unique<MicrostepJob>(std::move(step), range, memory());
  state_.work = job_->stage();
}

std::optional<RecordedStep> MicrostepPlayer::take() {
  const std::unique_ptr<MicrostepJob> job = std::exchange(job_, nullptr);
  try {
    return job->take();
  } catch (const Cancelled&) {
    return std::nullopt;
  }
}

void MicrostepPlayer::show(RecordedStep recorded) {
  recorded_ = std::move(recorded);
  view_ = view_of(*recorded_, memory());
  const auto& moments = view_->moments;
  const auto at = std::ranges::lower_bound(moments, sought_, {}, &ui::MicrostepView::Moment::microstep);
  state_.microsteps.emplace();
  go_to(at - moments.begin());
}

void MicrostepPlayer::close() {
  state_.microsteps.reset();
  recorded_.reset();
  view_.reset();
}

const World* MicrostepPlayer::world() const {
  if (!recorded_) return nullptr;
  return &recorded_->recording.moments()[static_cast<std::size_t>(state_.microsteps->moment())].world;
}

void MicrostepPlayer::go_to(std::int64_t moment) {
  state_.microsteps->place = static_cast<double>(std::clamp<std::int64_t>(moment, 0, last()));
}

void MicrostepPlayer::toggle() {
  ui::MicrostepPlayback& playback = *state_.microsteps;
  playback.playing = !playback.playing;
  if (playback.playing && playback.moment() == last()) playback.place = 0;
}

bool MicrostepPlayer::play(double elapsed) {
  if (!state_.microsteps || !state_.microsteps->playing) return false;
  constexpr double kLongest = 0.1;  // [s] longer pictures, as after a pause, skip no microsteps
  ui::MicrostepPlayback& playback = *state_.microsteps;
  const int before = playback.moment();
  const double end = last();
  playback.place = std::min(playback.place + std::min(elapsed, kLongest) * end / state_.microstep_seconds, end);
  playback.playing = playback.moment() < last();
  return playback.moment() != before;
}

void MicrostepPlayer::record_finer() {
  constexpr std::int64_t kFiner = 8;
  const std::int64_t interval = std::max<std::int64_t>(1, view_->interval / kFiner);
  const std::int64_t half = interval * (std::int64_t{last()} + 1) / 2;
  sought_ = view_->moments[static_cast<std::size_t>(state_.microsteps->moment())].microstep;
  const std::int64_t first = std::max<std::int64_t>(1, sought_ - half / interval * interval);
  begin(recorded_->before, MicrostepRange{first, sought_ + half, interval});
}

}  // namespace griffith::app
