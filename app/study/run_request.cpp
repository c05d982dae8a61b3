#include "app/study/run_request.h"

#include <algorithm>
#include <array>
#include <csignal>

#include "app/shared/processes.h"
#include "app/study/parameter.h"
#include "sim/core/replace_file.h"

namespace griffith::app {
namespace {

using Words = std::vector<std::string>;

/// True if the signal may come from outside: from a user who wants this program to end, too, or for lack of memory.
bool from_without(const ProcessOutcome& outcome) {
  constexpr std::array kSignals = {SIGKILL, SIGTERM, SIGINT, SIGHUP};
  return outcome.end == ProcessOutcome::End::killed_by_signal &&
         std::ranges::find(kSignals, outcome.code) != kSignals.end();
}

}  // namespace

Words with_scene(Words beginning, const RunRequest& request) {
  beginning.push_back(request.scene.string());
  for (const SceneSetting& setting : request.settings) {
    beginning.emplace_back("--set");
    beginning.push_back(setting.pointer.substr(1) + "=" + setting_word(setting.value));
  }
  return beginning;
}

Words simulate_words(const RunRequest& request, const std::filesystem::path& record) {
  Words words = with_scene({request.program.string(), "simulate"}, request);
  for (const std::string& word : {std::string("--frames"), std::to_string(request.frames), std::string("--threads"),
                                  std::string("1"), std::string("--outcomes"), record.string()})
    words.push_back(word);
  return words;
}

Words render_words(const RunRequest& request, int frame, const std::filesystem::path& picture) {
  Words words = with_scene({request.program.string(), "render"}, request);
  for (const std::string& word :
       {std::string("--frame"), std::to_string(frame), std::string("--size"), std::string("320x200"),
        std::string("--no-legend"), std::string("--threads"), std::string("1"), std::string("-o"), picture.string()})
    words.push_back(word);
  return words;
}

Words editor_words(const RunRequest& request) { return with_scene({request.program.string()}, request); }

bool make_run(const RunRequest& request, const std::filesystem::path& record, const ProcessLimits& limits,
              const std::function<bool()>& cancelled) {
  constexpr int kAttempts = 3;
  ProcessOutcome outcome;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    outcome = run_process(simulate_words(request, record), limits, {}, cancelled);
    if (outcome.succeeded()) return true;
    if (outcome.end == ProcessOutcome::End::cancelled) return false;
    if (!from_without(outcome)) break;
  }
  replace_file(record, record_json({{}, failure_text(outcome, limits)}));
  return true;
}

}  // namespace griffith::app
