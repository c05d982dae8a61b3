#include "app/interruption.h"

#include <csignal>

namespace griffith::app {
namespace {

// The one thing that a signal handler may write to.
volatile std::sig_atomic_t interruptions = 0;

void note(int) {
  constexpr int kPatience = 3;  // supervisors such as timeout(1) send the signal twice
  interruptions = interruptions + 1;
  if (interruptions >= kPatience) std::signal(SIGINT, SIG_DFL);
}

}  // namespace

Interruption::Interruption() {
  interruptions = 0;
  std::signal(SIGINT, note);
}
Interruption::~Interruption() { std::signal(SIGINT, SIG_DFL); }

bool Interruption::requested() const { return interruptions != 0; }

}  // namespace griffith::app
