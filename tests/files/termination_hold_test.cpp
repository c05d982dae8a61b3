#include "sim/core/termination_hold.h"

#include <csignal>
#include <cstdio>

#include "test_folder.h"

namespace griffith {
namespace {

using namespace griffith::testing;

/// Removes its file and ends by the signal, or exits where it was not held.
void clean_up_and_end(int signal, const std::filesystem::path& file) {
  {
    const TerminationHold outer;
    {
      const TerminationHold inner;
      std::raise(signal);
      if (!inner.requested()) std::_Exit(1);
    }
    std::filesystem::remove(file);
  }
  std::_Exit(2);
}

TEST(TerminationHoldDeathTest, TheSignalTakesItsCourseAfterTheCleaningUp) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const auto file = written(empty_folder() / "temporary", "x");
    EXPECT_EXIT(clean_up_and_end(signal, file), ::testing::KilledBySignal(signal), "");
    EXPECT_FALSE(std::filesystem::exists(file));
  }
}

TEST(TerminationHoldDeathTest, AFourthSignalActsAtOnce) {
  const auto insist = [] {
    const TerminationHold hold;
    for (int i = 0; i < 4; ++i) std::raise(SIGINT);
    std::_Exit(2);
  };
  EXPECT_EXIT(insist(), ::testing::KilledBySignal(SIGINT), "");
}

TEST(TerminationHoldDeathTest, WhatIsIgnoredStaysIgnored) {
  const auto under_nohup = [] {
    std::signal(SIGHUP, SIG_IGN);
    {
      const TerminationHold hold;
      std::raise(SIGHUP);
      if (hold.requested()) std::_Exit(1);
    }
    std::_Exit(0);
  };
  EXPECT_EXIT(under_nohup(), ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace griffith
