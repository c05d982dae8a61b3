#pragma once

#include <optional>
#include <vector>

#include "app/study/sweep.h"
#include "sim/core/descriptor.h"

namespace griffith::app {

/// Keeps a second sweep out of the same folder while it lives, also when it is killed.
class FolderLock {
 public:
  /// Throws InputError when another sweep is at work there.
  explicit FolderLock(const std::filesystem::path& folder);

 private:
  Descriptor folder_;
};

/// Makes the folder, or takes up the sweep in it. Throws InputError when it holds another sweep, saying what differs,
/// and when it cannot be written.
void take_up(const Sweep& sweep);

/// The runs that have no record.
std::vector<std::size_t> missing_runs(const Sweep& sweep);

/// The records, nothing for runs that have none. Throws InputError for one that is none.
std::vector<std::optional<RunRecord>> read_records(const Sweep& sweep);

/// Removes the records of runs that failed.
void forget_failed_runs(const Sweep& sweep);

}  // namespace griffith::app
