#include "app/shared/processes.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstring>
#include <exception>
#include <mutex>
#include <string_view>
#include <thread>

namespace griffith::app {
namespace {

std::string quoted(const std::string& word) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./:,@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

/// Returns the last lines of a program's output, joined and limited to 300 bytes.
std::string last_words(std::string output) {
  constexpr std::size_t kLength = 300;
  std::ranges::replace(output, '\n', ' ');
  const std::size_t message = output.rfind("griffith: ");
  if (message != std::string::npos) output.erase(0, message + 10);
  output.erase(output.find_last_not_of(' ') + 1);
  if (message != std::string::npos) return output.substr(0, kLength);
  return output.substr(output.size() - std::min(output.size(), kLength));
}

std::string seconds_text(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", seconds);
  return text;
}

}  // namespace

std::string shell_command(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text.append(text.empty() ? "" : " ").append(quoted(word));
  return text;
}

std::string failure_text(const ProcessOutcome& outcome, const ProcessLimits& limits) {
  switch (outcome.end) {
    case ProcessOutcome::End::out_of_time:
      return "took more than " + seconds_text(limits.seconds) + " s";
    case ProcessOutcome::End::killed_by_signal:
      return "ended by signal " + std::to_string(outcome.code) + " (" + strsignal(outcome.code) + ")";
    case ProcessOutcome::End::not_found:
      return "the program cannot be started, perhaps for lack of memory";
    default:
      break;
  }
  const std::string words = last_words(outcome.output);
  return words.empty() ? "ended with exit code " + std::to_string(outcome.code) : words;
}

void work_side_by_side(std::size_t count, int jobs, const std::function<void(std::size_t)>& work,
                       const std::function<bool()>& cancelled) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr failure;  // under `mutex`
  const auto work_loop = [&] {
    try {
      for (std::size_t i = next++; i < count && !cancelled(); i = next++) work(i);
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
      next = count;
    }
  };
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < std::min(count, static_cast<std::size_t>(jobs)); ++i) threads.emplace_back(work_loop);
  }
  if (failure) std::rethrow_exception(failure);
}

std::filesystem::path this_program() { return std::filesystem::read_symlink("/proc/self/exe"); }

}  // namespace griffith::app
