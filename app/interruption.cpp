#include "app/interruption.h"

#include <csignal>

namespace griffith::app {
namespace {

// The one thing that a signal handler may write to.
volatile std::sig_atomic_t interrupted = 0;

void note(int) {
  interrupted = 1;
  std::signal(SIGINT, SIG_DFL);
}

}  // namespace

Interruption::Interruption() {
  interrupted = 0;
  std::signal(SIGINT, note);
}
Interruption::~Interruption() { std::signal(SIGINT, SIG_DFL); }

bool Interruption::requested() const { return interrupted != 0; }

}  // namespace griffith::app
