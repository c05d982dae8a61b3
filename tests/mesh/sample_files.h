#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim/core/temporary_folder.h"
#include "sim/mesh/tet_mesh.h"

namespace griffith::testing {

/// The same mesh in one of the formats that read_mesh() knows.
struct SampleFile {
  std::string format;                        ///< for messages
  std::string path;                          ///< to be read, within the folder
  std::map<std::string, std::string> files;  ///< path within the folder → content
  int skipped_elements = 0;                  ///< elements that are no tets
};

/// A mesh in every format and variant.
std::vector<SampleFile> sample_files(const TetSoup& soup);

/// A folder of its own to write files into, removed in the end.
class TemporaryFolder : public griffith::TemporaryFolder {
 public:
  void write(const SampleFile& sample) const;
  void write(const std::string& name, const std::string& content) const;
};

}  // namespace griffith::testing
