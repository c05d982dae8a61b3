#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace griffith::app {

/// A line of a comparison of two texts.
struct DiffLine {
  enum class Kind { same, removed, added, skipped };  ///< skipped: stands for equal lines that are left out
  Kind kind = Kind::same;
  std::string text;

  bool operator==(const DiffLine&) const = default;
};

/// Returns the fewest lines to remove and add to get from `golden` to `actual`, each with `context` equal lines around
/// it. Empty for equal texts. If more than about 2,000 lines lie between the first and the last change, all of them
/// count as changed.
std::vector<DiffLine> compare_text(std::string_view golden, std::string_view actual, int context = 2);

}  // namespace griffith::app
