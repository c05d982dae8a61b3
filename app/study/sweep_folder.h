#pragma once

#include <optional>
#include <vector>

#include "app/study/sweep.h"
#include "sim/core/descriptor.h"

namespace griffith::app {

/// Locks the folder against a second sweep as long as it exists, even if the process is killed.
class FolderLock {
 public:
  /// Throws InputError if another sweep is running there.
  explicit FolderLock(const std::filesystem::path& folder);

 private:
  Descriptor folder_;
};

/// Makes the folder, or continues the sweep in it. Throws InputError if it holds another sweep, naming the difference,
/// or if it cannot be written.
void prepare_folder(const Sweep& sweep);

/// Returns the runs without a record.
std::vector<std::size_t> missing_runs(const Sweep& sweep);

/// Reads the records, empty for runs that have none. Throws InputError for an invalid one.
std::vector<std::optional<RunRecord>> read_records(const Sweep& sweep);

/// Removes the records of failed runs.
void remove_failed_records(const Sweep& sweep);

}  // namespace griffith::app
