#pragma once

#include <string>
#include <vector>

#include "sim/scene/scene_reader.h"

namespace griffith {

/// Returns the reader's problems with a document named doc.
inline std::vector<InputError> problems_of(const std::string& text) { return check_scene_text(text, "doc"); }

inline std::vector<std::string> places(const std::vector<InputError>& problems) {
  std::vector<std::string> where;
  for (const InputError& problem : problems) where.push_back(problem.where());
  return where;
}

}  // namespace griffith
