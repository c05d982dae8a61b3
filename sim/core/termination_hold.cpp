#include "sim/core/termination_hold.h"

#include <array>
#include <atomic>
#include <csignal>
#include <mutex>

namespace griffith {
namespace {

constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP};

// Signal handling belongs to the process, so there is one of each of these.
std::atomic<int> last_signal = 0, signals = 0;
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler writes to it");
std::mutex mutex;
int holds = 0;                                             // under `mutex`
std::array<struct sigaction, kSignals.size()> usual = {};  // under `mutex`

void note(int signal) {
  constexpr int kMaxHeldSignals = 3;
  last_signal = signal;
  if (++signals >= kMaxHeldSignals) std::signal(signal, SIG_DFL);
}

}  // namespace

TerminationHold::TerminationHold() {
  const std::lock_guard lock(mutex);
  if (holds++ > 0) return;
  last_signal = signals = 0;
  struct sigaction noting {};
  noting.sa_handler = note;
  noting.sa_flags = SA_RESTART;
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], nullptr, &usual[i]);
    if (usual[i].sa_handler != SIG_IGN) sigaction(kSignals[i], &noting, nullptr);  // nohup(1) ignores SIGHUP
  }
}

TerminationHold::~TerminationHold() {
  const std::lock_guard lock(mutex);
  if (--holds > 0) return;
  for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &usual[i], nullptr);
  if (last_signal != 0) std::raise(last_signal);
}

bool TerminationHold::requested() const { return last_signal != 0; }

}  // namespace griffith
