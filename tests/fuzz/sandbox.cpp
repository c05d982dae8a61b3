#include "tests/fuzz/sandbox.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <new>
#include <sstream>
#include <system_error>
#include <thread>
#include <typeinfo>

#include "sim/core/error.h"
#include "sim/core/parallel.h"

namespace griffith::fuzz {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kFailed = 77;
/// A process that sleeps so long is blocked; one among many others is ready to run and waits its turn [s].
constexpr double kLongestSleep = 60;

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

double own_processor_seconds() {
  double sum = 0;
  for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    getrusage(who, &usage);
    sum += seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
  }
  return sum;
}

/// State of a process from /proc: readiness to run, and its processor time including that of its own ended children
/// [s].
struct ProcessState {
  bool runs = false;
  double processor_seconds = 0;
};

ProcessState state_of(int process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  std::getline(file, text);
  std::istringstream fields(text.substr(std::min(text.size(), text.rfind(')') + 1)));
  std::string letter, skipped;
  fields >> letter;
  for (int i = 0; i < 10; ++i) fields >> skipped;
  double ticks = 0, sum = 0;
  for (int i = 0; i < 4 && fields >> ticks; ++i) sum += ticks;
  return {letter == "R", sum / static_cast<double>(sysconf(_SC_CLK_TCK))};
}

std::int64_t resident_bytes_of(int process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/statm");
  std::int64_t total = 0, resident = 0;
  file >> total >> resident;
  return resident * sysconf(_SC_PAGESIZE);
}

void limit(__rlimit_resource resource, rlim_t maximum) {
  const rlimit both = {maximum, maximum};
  setrlimit(resource, &both);
}

/// The last words of a process: a sanitizer's summary and report, or whatever there is.
std::string end_of(const std::filesystem::path& file) {
  constexpr std::size_t kMaximum = 4000;
  const std::string text = read_file(file);
  const std::size_t summary = text.find("SUMMARY: "), error = text.find("ERROR: ");
  if (summary == std::string::npos) return "\n" + text.substr(text.size() - std::min(text.size(), kMaximum));
  return ", " + text.substr(summary, text.find('\n', summary) + 1 - summary) +
         text.substr(std::min(error, summary), kMaximum);
}

[[noreturn]] void give_up(Report& report, Failure::Kind kind, const std::string& message) {
  std::strncpy(report.message, message.c_str(), sizeof report.message - 1);
  report.failure = static_cast<int>(kind);
  _exit(kFailed);
}

}  // namespace

const char* name_of(Failure::Kind kind) {
  constexpr const char* kNames[] = {"broken promise", "unexpected exception", "crash", "hang", "too much memory"};
  return kNames[static_cast<int>(kind)];
}

std::string Failure::signature() const {
  return std::string(name_of(kind)) + ": " + message.substr(0, message.find_first_of("0123456789\n"));
}

Outcome run_input(const Target& target, const Input& input, const std::filesystem::path& folder) try {
  write_input(input, folder);
  return target.run(input, folder);
} catch (const InputError& error) {
  promise(!error.where().empty() && !error.problem().empty(), "an error names neither place nor problem");
  return Outcome::refused;
}

Sandbox::Sandbox(std::filesystem::path folder, const Limits& limits) : folder_(std::move(folder)), limits_(limits) {
  std::filesystem::create_directories(folder_ / "temporary");
  void* memory = mmap(nullptr, sizeof(Report), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::system_error(errno, std::generic_category(), "mmap");
  report_ = new (memory) Report;
}
Sandbox::~Sandbox() { munmap(report_, sizeof(Report)); }

void Sandbox::begin(std::uint64_t input) {
  report_->processor_seconds = own_processor_seconds();
  report_->input = input;
}

std::optional<Failure> Sandbox::run(const std::function<void()>& work) {
  report_->failure = -1;
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) limit_and_work(work);
  return watch(child);
}

/// The child's life. Its temporary files and its cache of meshes are the sandbox's.
void Sandbox::limit_and_work(const std::function<void()>& work) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  limit(RLIMIT_CORE, 0);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  limit(RLIMIT_AS, static_cast<rlim_t>(limits_.memory_bytes));
#endif
  setenv("TMPDIR", (folder_ / "temporary").c_str(), 1);
  setenv("XDG_CACHE_HOME", (folder_ / "cache").c_str(), 1);
  const int log = open((folder_ / "log").c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  try {
    work();
  } catch (const BrokenPromise& broken) {
    give_up(*report_, Failure::Kind::promise, broken.what());
  } catch (const std::bad_alloc&) {
    give_up(*report_, Failure::Kind::memory, "std::bad_alloc");
  } catch (const std::exception& error) {
    give_up(*report_, Failure::Kind::exception, std::string(typeid(error).name()) + ": " + error.what());
  } catch (...) {
    give_up(*report_, Failure::Kind::exception, "of a type that is no std::exception");
  }
  _exit(0);
}

std::optional<Failure> Sandbox::overrun(int child) const {
  const std::uint64_t input = report_->input;
  const double used = state_of(child).processor_seconds - report_->processor_seconds;
  if (report_->input != input) return {};
  if (used > limits_.seconds) return Failure{Failure::Kind::hang, "more than the allowed processor time"};
  if (resident_bytes_of(child) > limits_.memory_bytes) return Failure{Failure::Kind::memory, "resident memory"};
  return {};
}

std::optional<Failure> Sandbox::watch(int child) {
  constexpr auto kFirstPause = std::chrono::microseconds(200), kLongestPause = std::chrono::microseconds(20000);
  auto pause = kFirstPause;
  std::uint64_t input = report_->input;
  for (auto since = Clock::now();;) {
    int status = 0;
    if (waitpid(child, &status, WNOHANG) == child) return status == 0 ? std::optional<Failure>{} : failure_of(status);
    if (report_->input != input || state_of(child).runs) input = report_->input, since = Clock::now();
    std::optional<Failure> failure = overrun(child);
    const std::chrono::duration<double> asleep = Clock::now() - since;
    if (asleep.count() > kLongestSleep) failure = Failure{Failure::Kind::hang, "it waits for ever"};
    if (failure) {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      return failure;
    }
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, kLongestPause);
  }
}

Failure Sandbox::failure_of(int status) const {
  if (WIFEXITED(status) && WEXITSTATUS(status) == kFailed)
    return {static_cast<Failure::Kind>(report_->failure.load()), report_->message};
  const std::string how = WIFSIGNALED(status) ? std::string("signal ") + strsignal(WTERMSIG(status))
                                              : "exit code " + std::to_string(WEXITSTATUS(status));
  return {Failure::Kind::crash, how + end_of(folder_ / "log")};
}

std::optional<Failure> Sandbox::run_one(const Target& target, const Input& input) {
  return run([&] {
    const ThreadLimit one(1);
    begin(report_->input + 1);
    run_input(target, input, folder_ / "input");
  });
}

}  // namespace griffith::fuzz
