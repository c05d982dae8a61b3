#include "sim/core/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>

namespace griffith {
namespace {

using End = ProcessOutcome::End;

constexpr ProcessLimits kLimits = {20, std::int64_t{1} << 30};

ProcessOutcome shell(const std::string& script, const ProcessLimits& limits = kLimits,
                     const std::function<bool()>& cancelled = {}) {
  return run_process({"sh", "-c", script}, limits, {}, cancelled);
}

double seconds_of(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

TEST(Process, GivesLinesOutputAndExitCode) {
  std::vector<std::string> lines;
  const ProcessOutcome outcome = run_process({"sh", "-c", "echo one; echo two >&2; exit 3"}, kLimits,
                                             [&](const std::string& line) { lines.push_back(line); });
  EXPECT_EQ(outcome.end, End::exited);
  EXPECT_EQ(outcome.code, 3);
  EXPECT_FALSE(outcome.succeeded());
  EXPECT_EQ(outcome.output, "one\ntwo\n");
  EXPECT_THAT(lines, ::testing::ElementsAre("one", "two"));
  EXPECT_TRUE(shell("true").succeeded());
}

TEST(Process, IsHeldToItsTimeWhenItHasClosedItsOutput) {
  const ProcessLimits brief = {0.3, kLimits.memory_bytes};
  EXPECT_LT(seconds_of([&] { EXPECT_EQ(shell("exec >&- 2>&-; sleep 20", brief).end, End::out_of_time); }), 10);
  EXPECT_EQ(shell("exec >&- 2>&-; sleep 0.1; exit 7").code, 7);
}

TEST(Process, HasNoInput) { EXPECT_EQ(shell("cat; echo end").output, "end\n"); }

TEST(Process, AProgramThatIsNotThereIsNotFound) {
  EXPECT_EQ(run_process({"no-such-program-here"}, kLimits).end, End::not_found);
}

TEST(Process, ASignalIsDistinguishedFromAnExitCode) {
  const ProcessOutcome outcome = shell("kill -ABRT $$");
  EXPECT_EQ(outcome.end, End::killed_by_signal);
  EXPECT_EQ(outcome.code, SIGABRT);
}

TEST(Process, TheTimeLimitEndsItWithAllItsChildren) {
  ProcessOutcome outcome;
  const double seconds = seconds_of([&] {
    outcome = shell("echo before; sleep 30 & sleep 30", {0.3, kLimits.memory_bytes});
  });
  EXPECT_EQ(outcome.end, End::out_of_time);
  EXPECT_EQ(outcome.output, "before\n");
  EXPECT_LT(seconds, 5);
}

TEST(Process, TheMemoryLimitHolds) {
  const ProcessLimits limits = {20, std::int64_t{64} << 20};
  EXPECT_FALSE(shell("head -c 200000000 /dev/zero | tail", limits).output.empty());
}

TEST(Process, CancellingEndsIt) {
  ProcessOutcome outcome;
  int asked = 0;
  const double seconds = seconds_of([&] { outcome = shell("sleep 30", kLimits, [&] { return ++asked > 2; }); });
  EXPECT_EQ(outcome.end, End::cancelled);
  EXPECT_LT(seconds, 5);
}

TEST(Process, OfMuchOutputTheEndIsKept) {
  const ProcessOutcome outcome = shell("yes | head -c 5000000; echo last");
  EXPECT_TRUE(outcome.output.ends_with("last\n"));
  EXPECT_LT(outcome.output.size(), 3u << 20);
}

}  // namespace
}  // namespace griffith
