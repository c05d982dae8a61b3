#pragma once

#include <filesystem>

#include "sim/core/termination_hold.h"

namespace griffith {

/// New folder for temporary files. It is removed with its contents by the destructor, also if the program is asked to
/// end by SIGINT, SIGTERM or SIGHUP. The folder of a killed program is removed by the next one. Throws InputError if no
/// folder can be created.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// True if the work in it should end, because the program was asked to end.
  bool termination_requested() const { return hold_.requested(); }

 private:
  TerminationHold hold_;
  std::filesystem::path path_;
  int lock_ = -1;  ///< descriptor whose lock marks the folder as in use; -1: none
};

}  // namespace griffith
