#include "app/regress/compare_ids.h"

#include <algorithm>
#include <iterator>

namespace griffith::app {
namespace {

std::vector<std::int32_t> sorted_ids(std::vector<std::int32_t> ids) {
  std::ranges::sort(ids);
  ids.erase(std::ranges::unique(ids).begin(), ids.end());
  return ids;
}

/// Lists the ids in `all` that are not in `other`, both sorted: "; gone: 3, 7 and 12 others".
std::string missing_text(const char* what, const std::vector<std::int32_t>& all,
                         const std::vector<std::int32_t>& other) {
  constexpr std::size_t kNamed = 6;
  std::vector<std::int32_t> missing;
  std::ranges::set_difference(all, other, std::back_inserter(missing));
  std::string text;
  for (std::size_t i = 0; i < std::min(missing.size(), kNamed); ++i)
    text += (i == 0 ? std::string("; ") + what + ": " : ", ") + std::to_string(missing[i]);
  if (missing.size() > kNamed) text += " and " + std::to_string(missing.size() - kNamed) + " more";
  return text;
}

}  // namespace

IdComparison compare_ids(const render::IdImage& golden, const render::IdImage& actual, const OffLimits& limits) {
  IdComparison comparison;
  if (golden.width != actual.width || golden.height != actual.height) {
    comparison.reason = "the pictures of ids differ in size";
    return comparison;
  }
  PixelMask mask{golden.width, golden.height, std::vector<std::uint8_t>(golden.ids.size())};
  for (std::size_t i = 0; i < mask.off.size(); ++i) mask.off[i] = golden.ids[i] != actual.ids[i];
  comparison.off = count_off(mask);
  comparison.rules = off_rules(comparison.off, limits, "ids");
  comparison.passed = are_kept(comparison.rules);
  const std::vector<std::int32_t> before = sorted_ids(golden.ids), now = sorted_ids(actual.ids);
  comparison.reason = (comparison.passed ? "within the tolerance" : broken_rules(comparison.rules)) +
                      missing_text("gone", before, now) + missing_text("new", now, before);
  return comparison;
}

}  // namespace griffith::app
