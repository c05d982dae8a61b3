#include "tests/fuzz/campaign.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <set>
#include <system_error>

#include "sim/core/parallel.h"
#include "sim/core/temporary_folder.h"
#include "tests/fuzz/minimize.h"

namespace griffith::fuzz {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Mixes bits (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014).
std::uint64_t mixed(std::uint64_t value) {
  value = (value ^ value >> 30) * 0xbf58476d1ce4e5b9u;
  value = (value ^ value >> 27) * 0x94d049bb133111ebu;
  return value ^ value >> 31;
}

/// One process that tries every jobs-th input, each in a sandbox.
class Job {
 public:
  Job(const Targets& targets, const Campaign& campaign, int job)
      : targets_(targets),
        campaign_(campaign),
        next_(campaign.first + static_cast<std::uint64_t>(job)),
        sandbox_(folder_.path(), campaign.limits) {}

  /// Returns the number of different failures.
  int run() {
    while (!at_end(next_) && std::ssize(known_) < campaign_.max_findings)
      if (const auto failure = sandbox_.run([this] { work(); })) {
        const std::uint64_t failed = sandbox_.report().input;
        save(failed, *failure);
        next_ = failed + static_cast<std::uint64_t>(campaign_.jobs);
      } else {
        next_ = sandbox_.report().input + static_cast<std::uint64_t>(campaign_.jobs);
      }
    print_outcomes();
    return static_cast<int>(known_.size());
  }

 private:
  bool at_end(std::uint64_t input) const {
    const std::chrono::duration<double> passed = Clock::now() - begin_;
    return input - campaign_.first >= campaign_.inputs || passed.count() >= campaign_.seconds;
  }

  /// In the sandbox: so many inputs that memory which is never given back does not matter.
  void work() {
    constexpr int kInputs = 20000;
    const ThreadLimit limit(campaign_.threads);
    std::uint64_t number = next_;
    for (int i = 0; i < kInputs && !at_end(number); ++i, number += static_cast<std::uint64_t>(campaign_.jobs)) {
      const NumberedInput made = make_input(targets_, campaign_.seed, number);
      sandbox_.begin(number);
      const Outcome outcome = run_input(*made.target, made.input, folder_.path() / "input");
      ++sandbox_.report().outcomes[made.target_index][static_cast<int>(outcome)];
    }
  }

  void save(std::uint64_t number, const Failure& failure) {
    const NumberedInput made = make_input(targets_, campaign_.seed, number);
    const std::string name = made.target->name() + "-" + std::to_string(campaign_.seed) + "-" + std::to_string(number);
    const bool is_new = known_.insert(made.target->name() + failure.signature()).second;
    std::printf("%s: %s: %s%s\n", name.c_str(), name_of(failure.kind),
                failure.message.substr(0, failure.message.find('\n')).c_str(), is_new ? "" : " (again)");
    std::fflush(stdout);
    if (!is_new) return;
    const fs::path folder = campaign_.findings / made.target->name() / name;
    write_input(made.input, folder);
    if (campaign_.minimize) write_input(minimized(sandbox_, *made.target, made.input, failure), folder);
    std::ofstream(folder / "what.txt") << name_of(failure.kind) << ": " << failure.message << "\n";
  }

  void print_outcomes() {
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      const auto& [refused, too_large, ran] = sandbox_.report().outcomes[i];
      std::printf("%-8s %8llu inputs: %llu refused, %llu too large, %llu ran\n", targets_[i]->name().c_str(),
                  static_cast<unsigned long long>(refused + too_large + ran), static_cast<unsigned long long>(refused),
                  static_cast<unsigned long long>(too_large), static_cast<unsigned long long>(ran));
    }
    std::fflush(stdout);
  }

  const Targets& targets_;
  const Campaign& campaign_;
  std::uint64_t next_;
  const TemporaryFolder folder_;
  Sandbox sandbox_;
  Clock::time_point begin_ = Clock::now();
  std::set<std::string> known_;
};

}  // namespace

NumberedInput make_input(const Targets& targets, std::uint64_t seed, std::uint64_t number) {
  RandomValues random(static_cast<unsigned>(mixed(mixed(seed) + number)));
  int sum = 0;
  for (const auto& target : targets) sum += target->fraction();
  std::size_t index = 0;
  for (int at = random.index(sum); at >= targets[index]->fraction(); ++index) at -= targets[index]->fraction();
  return {targets[index].get(), index, targets[index]->make(random)};
}

int run_campaign(const Targets& targets, const Campaign& campaign) {
  if (campaign.jobs == 1) return Job(targets, campaign, 0).run();
  std::vector<pid_t> children;
  for (int job = 0; job < campaign.jobs; ++job) {
    const pid_t child = fork();
    if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
    if (child == 0) _exit(std::min(Job(targets, campaign, job).run(), 100));
    children.push_back(child);
  }
  int findings = 0;
  for (const pid_t child : children) {
    int status = 0;
    waitpid(child, &status, 0);
    findings += WIFEXITED(status) ? WEXITSTATUS(status) : 1;
  }
  return findings;
}

}  // namespace griffith::fuzz
