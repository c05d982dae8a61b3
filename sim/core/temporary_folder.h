#pragma once

#include <filesystem>

#include "sim/core/termination_hold.h"

namespace griffith {

/// A new folder for temporary files, gone with its contents at the end, also when the program is asked to end meanwhile
/// (by SIGINT, SIGTERM or SIGHUP). One that was killed leaves its folder to the next, which removes it. Throws
/// InputError when none can be made.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Whether work in it should be given up, because the program was asked to end.
  bool termination_requested() const { return hold_.requested(); }

 private:
  TerminationHold hold_;
  std::filesystem::path path_;
  int lock_ = -1;  ///< descriptor whose lock tells others that the folder is in use; -1: none
};

}  // namespace griffith
