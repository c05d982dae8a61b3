#include "sim/core/process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <limits>
#include <stdexcept>
#include <system_error>

namespace griffith {
namespace {

constexpr int kNotFound = 127;  ///< exit code of the shell for a program that cannot be started
constexpr int kPollMilliseconds = 50, kPollClosedMilliseconds = 5;  // while the child writes; afterward
constexpr std::size_t kMaxOutput = 1 << 20;

/// Pipe whose ends are closed by its destructor.
class Pipe {
 public:
  Pipe() {
    if (pipe2(ends_.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  }
  ~Pipe() {
    close(ends_[0]);
    close_writer();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int reader() const { return ends_[0]; }
  int writer() const { return ends_[1]; }
  void close_writer() {
    if (ends_[1] >= 0) close(ends_[1]);
    ends_[1] = -1;
  }

 private:
  std::array<int, 2> ends_ = {-1, -1};
};

void limit(__rlimit_resource resource, rlim_t maximum) {
  const rlimit both = {maximum, maximum};
  setrlimit(resource, &both);
}

/// Replaces the child process by the program. Between fork() and execvp() only functions safe in signal handlers may be
/// called.
[[noreturn]] void become(char* const* arguments, const ProcessLimits& limits, int output) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (limits.memory_bytes < std::numeric_limits<std::int64_t>::max())
    limit(RLIMIT_AS, static_cast<rlim_t>(limits.memory_bytes));
  limit(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(std::max(limits.seconds, limits.processor_seconds))) + 1);
  limit(RLIMIT_CORE, 0);
  dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  execvp(arguments[0], arguments);
  _exit(kNotFound);
}

pid_t start(const std::vector<std::string>& arguments, const ProcessLimits& limits, int output) {
  std::vector<char*> pointers;
  for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
  pointers.push_back(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) become(pointers.data(), limits, output);
  return child;
}

/// Collects output and passes on its whole lines.
class LineReader {
 public:
  explicit LineReader(const std::function<void(const std::string&)>& on_line) : on_line_(on_line) {}

  /// Reads the available output. Returns false at its end.
  bool read_from(int file) {
    std::array<char, 4096> buffer;
    const ssize_t count = read(file, buffer.data(), buffer.size());
    if (count < 0) return errno == EINTR || errno == EAGAIN;
    for (ssize_t i = 0; i < count; ++i) {
      if (buffer[i] != '\n') {
        line_ += buffer[i];
        continue;
      }
      if (on_line_) on_line_(line_);
      line_.clear();
    }
    text.append(buffer.data(), static_cast<std::size_t>(count));
    if (text.size() > 2 * kMaxOutput) text.erase(0, text.size() - kMaxOutput);
    return count > 0;
  }

  std::string text;

 private:
  const std::function<void(const std::string&)>& on_line_;
  std::string line_;
};

/// Stores the end of the process; `options` are those of wait4(2). Returns false while it runs.
bool reap(pid_t child, int options, ProcessOutcome& outcome) {
  int status = 0;
  rusage usage{};
  pid_t ended = -1;
  while ((ended = wait4(child, &status, options, &usage)) < 0 && errno == EINTR) {
  }
  if (ended == 0) return false;
  outcome.peak_memory_bytes = std::int64_t{1024} * usage.ru_maxrss;
  if (outcome.end != ProcessOutcome::End::exited) return true;
  if (WIFEXITED(status)) {
    outcome.code = WEXITSTATUS(status);
    if (outcome.code == kNotFound) outcome.end = ProcessOutcome::End::not_found;
  } else {
    outcome.code = WTERMSIG(status);
    const bool overtime = outcome.code == SIGXCPU;
    outcome.end = overtime ? ProcessOutcome::End::out_of_time : ProcessOutcome::End::killed_by_signal;
  }
  return true;
}

}  // namespace

ProcessOutcome run_process(const std::vector<std::string>& arguments, const ProcessLimits& limits,
                           const std::function<void(const std::string&)>& on_line,
                           const std::function<bool()>& cancelled) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  Pipe pipe;
  const pid_t child = start(arguments, limits, pipe.writer());
  pipe.close_writer();
  LineReader reader(on_line);
  ProcessOutcome outcome;
  // A child may close its output and continue.
  for (bool open = true; open || !reap(child, WNOHANG, outcome);) {
    pollfd waiting = {pipe.reader(), POLLIN, 0};
    const int ready = poll(&waiting, open ? 1 : 0, open ? kPollMilliseconds : kPollClosedMilliseconds);
    if (open && ready > 0) open = reader.read_from(pipe.reader());
    const bool late = std::chrono::duration<double>(Clock::now() - begin).count() > limits.seconds;
    const bool stop = cancelled && cancelled();
    if (!late && !stop) continue;
    outcome.end = stop ? ProcessOutcome::End::cancelled : ProcessOutcome::End::out_of_time;
    kill(-child, SIGKILL);
    kill(child, SIGKILL);  // it may not lead its own group yet
    reap(child, 0, outcome);
    break;
  }
  outcome.output = std::move(reader.text);
  return outcome;
}

}  // namespace griffith
