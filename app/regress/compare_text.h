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

/// The fewest lines to remove and to add that make `golden` into `actual`, each with `context` equal lines about it.
/// Empty for equal texts. Where more than some 2,000 lines lie between the first and the last change, all of them are
/// taken for changed.
std::vector<DiffLine> compare_text(std::string_view golden, std::string_view actual, int context = 2);

}  // namespace griffith::app
