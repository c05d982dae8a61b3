#include "sim/contact/contact_reduction.h"

#include <algorithm>
#include <cmath>

namespace griffith {
namespace {

constexpr double kAlike = 0.95;  // cosine of the angle between two normals

/// The index in `group` with the largest value, the first of several.
template <class Value>
int best_of(const std::vector<int>& group, Value value) {
  return *std::max_element(group.begin(), group.end(), [&](int a, int b) { return value(a) < value(b); });
}

/// Four of more contacts with nearly the same normal.
std::vector<int> widest_four(std::span<const Contact> contacts, const std::vector<int>& group) {
  const auto at = [&](int i) -> const Vec3& { return contacts[i].position_on_a; };
  const int deepest = best_of(group, [&](int i) { return -contacts[i].distance; });
  const int farthest = best_of(group, [&](int i) { return (at(i) - at(deepest)).squaredNorm(); });
  const Vec3 across = contacts[deepest].normal.cross(at(farthest) - at(deepest));
  const auto side = [&](int i) { return across.dot(at(i) - at(deepest)); };
  std::vector<int> kept = {deepest, farthest, best_of(group, side), best_of(group, [&](int i) { return -side(i); })};
  std::sort(kept.begin(), kept.end());
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  return kept;
}

}  // namespace

std::vector<int> representative_contacts(std::span<const Contact> contacts) {
  std::vector<std::vector<int>> groups;
  for (int i = 0; i < static_cast<int>(contacts.size()); ++i) {
    const auto alike = std::find_if(groups.begin(), groups.end(), [&](const std::vector<int>& group) {
      return contacts[group.front()].normal.dot(contacts[i].normal) > kAlike;
    });
    (alike == groups.end() ? groups.emplace_back() : *alike).push_back(i);
  }
  std::vector<int> kept;
  for (const std::vector<int>& group : groups) {
    const std::vector<int> some = group.size() > 4 ? widest_four(contacts, group) : group;
    kept.insert(kept.end(), some.begin(), some.end());
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

}  // namespace griffith
