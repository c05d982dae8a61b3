#include "app/regress/compare_text.h"

#include <algorithm>

namespace griffith::app {
namespace {

using Kind = DiffLine::Kind;
using Lines = std::vector<std::string_view>;

Lines lines_of(std::string_view text) {
  Lines lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

/// Lengths of the longest common subsequences of the lines from i on of one text and from j on of the other.
class CommonLengths {
 public:
  CommonLengths(const Lines& a, const Lines& b) : columns_(b.size() + 1), lengths_((a.size() + 1) * columns_) {
    for (std::size_t i = a.size(); i-- > 0;)
      for (std::size_t j = b.size(); j-- > 0;)
        lengths_[i * columns_ + j] = a[i] == b[j] ? at(i + 1, j + 1) + 1 : std::max(at(i + 1, j), at(i, j + 1));
  }
  int at(std::size_t i, std::size_t j) const { return lengths_[i * columns_ + j]; }

 private:
  std::size_t columns_;
  std::vector<int> lengths_;
};

void add(std::vector<DiffLine>& diff, Kind kind, std::string_view line) { diff.push_back({kind, std::string(line)}); }

/// Adds the lines of both texts, whose first and last lines differ.
void add_changed(std::vector<DiffLine>& diff, const Lines& golden, const Lines& actual) {
  constexpr std::size_t kMostPairs = 4'000'000;
  std::size_t i = 0, j = 0;
  if (golden.size() * actual.size() <= kMostPairs) {
    const CommonLengths common(golden, actual);
    while (i < golden.size() && j < actual.size()) {
      if (golden[i] == actual[j]) {
        add(diff, Kind::same, golden[i]);
        ++i, ++j;
      } else if (common.at(i + 1, j) >= common.at(i, j + 1)) {
        add(diff, Kind::removed, golden[i++]);
      } else {
        add(diff, Kind::added, actual[j++]);
      }
    }
  }
  for (; i < golden.size(); ++i) add(diff, Kind::removed, golden[i]);
  for (; j < actual.size(); ++j) add(diff, Kind::added, actual[j]);
}

/// Removes the equal lines that are farther than `context` from any change.
std::vector<DiffLine> near_changes(const std::vector<DiffLine>& diff, int context) {
  std::vector<bool> shown(diff.size());
  const auto size = static_cast<std::ptrdiff_t>(diff.size());
  for (std::ptrdiff_t i = 0; i < size; ++i) {
    if (diff[i].kind == Kind::same) continue;
    for (auto k = std::max<std::ptrdiff_t>(i - context, 0); k <= std::min(i + context, size - 1); ++k) shown[k] = true;
  }
  std::vector<DiffLine> result;
  for (std::size_t i = 0; i < diff.size(); ++i) {
    if (shown[i]) {
      result.push_back(diff[i]);
    } else if (result.empty() || result.back().kind != Kind::skipped) {
      result.push_back({Kind::skipped, ""});
    }
  }
  return result;
}

}  // namespace

std::vector<DiffLine> compare_text(std::string_view golden, std::string_view actual, int context) {
  const Lines before = lines_of(golden), now = lines_of(actual);
  if (before == now) return {};
  const auto first = std::ranges::mismatch(before, now);
  const Lines rest_before(first.in1, before.end()), rest_now(first.in2, now.end());
  const auto last = std::mismatch(rest_before.rbegin(), rest_before.rend(), rest_now.rbegin(), rest_now.rend());
  std::vector<DiffLine> diff;
  for (auto line = before.begin(); line != first.in1; ++line) add(diff, Kind::same, *line);
  add_changed(diff, {rest_before.begin(), last.first.base()}, {rest_now.begin(), last.second.base()});
  for (auto line = last.first.base(); line != rest_before.end(); ++line) add(diff, Kind::same, *line);
  return near_changes(diff, context);
}

}  // namespace griffith::app
