#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tests/fuzz/target.h"

namespace griffith::fuzz {

/// Resource limits of an input.
struct Limits {
  double seconds = 10;  ///< processor time [s], including that of programs that it starts
  std::int64_t memory_bytes = std::int64_t{4} << 30;
};

/// Failure of an input.
struct Failure {
  enum class Kind { promise, exception, crash, hang, memory };
  Kind kind = Kind::crash;
  std::string message;

  /// Equal for failures that are likely to have one cause: the message without its numbers.
  std::string signature() const;
};
const char* name_of(Failure::Kind kind);

/// Report of a child process to its parent, in shared memory.
struct Report {
  std::atomic<std::uint64_t> input{0};           ///< the one in hand
  std::atomic<double> processor_seconds{0};      ///< processor time of the child when it began this input [s]
  std::atomic<std::uint64_t> outcomes[16][3]{};  ///< by target and outcome
  std::atomic<int> failure{-1};
  char message[1000] = {};
};

/// A process of its own for inputs that may crash it, hang it or fill its memory.
class Sandbox {
 public:
  /// `folder`: for temporary files, the sandbox's own.
  Sandbox(std::filesystem::path folder, const Limits& limits);
  ~Sandbox();
  Sandbox(const Sandbox&) = delete;
  Sandbox& operator=(const Sandbox&) = delete;

  Report& report() { return *report_; }
  const std::filesystem::path& folder() const { return folder_; }

  /// Runs `work`, which calls begin() for each input, in a new process; the failure that ended it, if any.
  std::optional<Failure> run(const std::function<void()>& work);
  /// In that process: an input is taken in hand.
  void begin(std::uint64_t input);
  /// Runs one input by itself.
  std::optional<Failure> run_one(const Target& target, const Input& input);

 private:
  void limit_and_work(const std::function<void()>& work);
  std::optional<Failure> watch(int child);
  std::optional<Failure> overrun(int child) const;
  Failure failure_of(int status) const;

  std::filesystem::path folder_;
  Limits limits_;
  Report* report_;
};

/// Runs an input in this process. Returns what became of it; failures are thrown, whatever their type.
Outcome run_input(const Target& target, const Input& input, const std::filesystem::path& folder);

}  // namespace griffith::fuzz
