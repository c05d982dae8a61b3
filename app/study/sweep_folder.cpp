#include "app/study/sweep_folder.h"

#include <fcntl.h>
#include <griffith/version.h>
#include <sys/file.h>

#include <nlohmann/json.hpp>

#include "app/shared/hash_text.h"
#include "sim/core/error.h"
#include "sim/core/hash_bytes.h"
#include "sim/core/read_file.h"
#include "sim/core/replace_file.h"
#include "sim/scene/json_document.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;
using Definition = nlohmann::ordered_json;

/// Returns the definition that determines the runs.
Definition definition_json(const SweepDefinition& definition) {
  return {{"program", "griffith " GRIFFITH_VERSION},
          {"scene_file", hash_text(hash_bytes(read_file(definition.scene)))},
          {"frames", definition.frames},
          {"set", definition.set},
          {"vary", definition.vary},
          {"latin_hypercube", definition.samples},
          {"seed", definition.seed},
          {"seeds", definition.seeds}};
}

fs::path plan_file(const Sweep& sweep) { return sweep.folder / "plan.json"; }

void require_same(const Sweep& sweep, const Definition& mine) {
  const std::string where = plan_file(sweep).string();
  constexpr std::int64_t kMaxBytes = 16 << 20;
  std::vector<InputError> problems;
  const Definition theirs = parse_json(read_file(plan_file(sweep), kMaxBytes), where, problems);
  if (!problems.empty()) throw problems.front();
  for (const auto& [key, value] : mine.items()) {
    if (theirs.is_object() && theirs.contains(key) && theirs[key] == value) continue;
    const std::string there = theirs.is_object() && theirs.contains(key) ? theirs[key].dump() : "missing";
    throw InputError(where, "belongs to another sweep: " + key + " is " + there + " there and " + value.dump() + " now",
                     "name another folder with -o, or repeat the command that made this one");
  }
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(folder.string(), "cannot be created: " + error.message(), "name another folder with -o");
}

}  // namespace

FolderLock::FolderLock(const fs::path& folder)
    : folder_((make_folder(folder), open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC))) {
  if (!folder_.is_open())
    throw InputError(folder.string(), "cannot be opened", "name a readable and writable folder with -o");
  if (flock(folder_.number(), LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  throw InputError(folder.string(), "is in use by another process", "wait for it, or name another folder with -o");
}

void prepare_folder(const Sweep& sweep) {
  make_folder(sweep.folder / "runs");
  remove_stale_files(sweep.folder / "runs");
  const Definition definition = definition_json(sweep.definition);
  std::error_code error;
  if (fs::exists(plan_file(sweep), error)) return require_same(sweep, definition);
  replace_file(plan_file(sweep), definition.dump(2) + "\n");
}

std::vector<std::size_t> missing_runs(const Sweep& sweep) {
  std::vector<std::size_t> missing;
  std::error_code error;
  for (std::size_t run = 0; run < sweep.size(); ++run)
    if (!fs::exists(sweep.record_file(run), error)) missing.push_back(run);
  return missing;
}

std::vector<std::optional<RunRecord>> read_records(const Sweep& sweep) {
  std::vector<std::optional<RunRecord>> records(sweep.size());
  std::error_code error;
  for (std::size_t run = 0; run < sweep.size(); ++run) {
    const fs::path file = sweep.record_file(run);
    if (fs::exists(file, error)) records[run] = record_from_json(read_file(file), file.string());
  }
  return records;
}

void remove_failed_records(const Sweep& sweep) {
  const std::vector<std::optional<RunRecord>> records = read_records(sweep);
  for (std::size_t run = 0; run < records.size(); ++run)
    if (records[run] && !records[run]->error.empty()) fs::remove(sweep.record_file(run));
}

}  // namespace griffith::app
