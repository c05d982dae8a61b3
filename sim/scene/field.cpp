#include "sim/scene/field.h"

#include <algorithm>
#include <numeric>

#include "sim/core/number_text.h"

namespace griffith {
namespace {

/// Returns the number of insertions, deletions and substitutions of a character that turn `a` into `b` (Levenshtein
/// 1966).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i] != b[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min({substituted, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string range_text(const Numbers& numbers) {
  std::string text = "from " + rounded_text(numbers.minimum, 6) + " to " + rounded_text(numbers.maximum, 6);
  if (!numbers.unit.empty() && numbers.unit != "-") text += std::string(" ").append(numbers.unit);
  return text;
}

std::string quoted_list(std::span<const std::string_view> names) {
  std::string text;
  for (std::string_view name : names) {
    if (!text.empty()) text += ", ";
    text.append(1, '"').append(name).append(1, '"');
  }
  return text;
}

std::string suggestion(std::string_view name, std::span<const std::string_view> known) {
  // A longer name is a different word, not a typo. The limit also bounds the work.
  constexpr std::size_t kLongestSlip = 64;
  std::string_view best;
  std::size_t best_distance = std::max<std::size_t>(2, name.size() / 3) + 1;
  for (std::string_view candidate : known) {
    if (name.size() > kLongestSlip) break;
    const std::size_t distance = edit_distance(name, candidate);
    if (distance < best_distance && distance < candidate.size()) best_distance = distance, best = candidate;
  }
  if (!best.empty()) return std::string("did you mean \"").append(best).append("\"?");
  return std::string("known here: ").append(quoted_list(known));
}

}  // namespace griffith
