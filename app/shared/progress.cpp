#include "app/shared/progress.h"

#include <unistd.h>

#include <cstdio>

namespace griffith::app {
namespace {

constexpr double kSecondsBetween = 0.1;

double seconds(std::chrono::steady_clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

}  // namespace

Progress::Progress(std::string label, int total)
    : label_(std::move(label)),
      total_(total),
      shown_(isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      last_(start_) {}

Progress::~Progress() {
  if (shown_) std::fprintf(stderr, "\r\033[K");
}

void Progress::update(int done) {
  const Clock::time_point now = Clock::now();
  if (!shown_ || seconds(now - last_) < kSecondsBetween) return;
  last_ = now;
  const double fraction = static_cast<double>(done) / total_;
  const double left = fraction > 0 ? seconds(now - start_) * (1 - fraction) / fraction : 0;
  std::fprintf(stderr, "\r\033[K%s %d/%d  %.0f %%  %.0f s left", label_.c_str(), done, total_, 100 * fraction, left);
}

StageProgress::StageProgress() : shown_(isatty(STDERR_FILENO) == 1) {}

StageProgress::~StageProgress() {
  if (shown_) std::fprintf(stderr, "\r\033[K");
}

void StageProgress::note(const std::string& line) {
  std::fprintf(stderr, "%s%s\n", shown_ ? "\r\033[K" : "", line.c_str());
}

void StageProgress::enter(std::string_view stage) {
  if (shown_) std::fprintf(stderr, "\r\033[K%.*s ...", static_cast<int>(stage.size()), stage.data());
}

}  // namespace griffith::app
