#include "sim/contact/contact_reduction.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace griffith {
namespace {

constexpr double kAlike = 0.95;  // cosine of the angle between two normals

/// Returns the index in `group` with the largest value, the first of several.
template <class Value>
int best_of(const std::vector<int>& group, Value value) {
  return *std::max_element(group.begin(), group.end(), [&](int a, int b) { return value(a) < value(b); });
}

/// Returns the outermost contacts along two axes of the contact plane. The choice changes little from step to step, so
/// that the last impulses stay a good guess.
std::vector<int> outermost_four(std::span<const Contact> contacts, const std::vector<int>& group) {
  const Vec3 normal = contacts[group.front()].normal, first = normal.unitOrthogonal(), second = normal.cross(first);
  std::vector<int> kept;
  for (const Vec3& direction :
       {Vec3(first + second), Vec3(first - second), Vec3(-first - second), Vec3(second - first)})
    kept.push_back(best_of(group, [&](int i) { return direction.dot(contacts[i].position); }));
  std::sort(kept.begin(), kept.end());
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  return kept;
}

/// Returns the contacts of a group that are deeper than all of `others` by more than a small share of the distances
/// from these, and than is allowed [m].
std::vector<int> deeper_than(std::span<const Contact> contacts, const std::vector<int>& group,
                             const std::vector<int>& others, double allowed) {
  constexpr double kMargin = 1e-3;
  std::vector<int> deeper;
  std::ranges::copy_if(group, std::back_inserter(deeper), [&](int contact) {
    const double distance = contacts[contact].distance;
    if (allowed > 0 && distance >= -allowed) return false;
    return std::ranges::all_of(others, [&](int i) {
      const double apart = (contacts[i].position - contacts[contact].position).norm();
      return distance < contacts[i].distance - kMargin * apart;
    });
  });
  return deeper;
}

/// Returns the outermost contacts, those of the deeper ones likewise, and so on: a rounded side would sink in between
/// the outermost alone.
std::vector<int> spanning_contacts(std::span<const Contact> contacts, std::vector<int> group, double allowed) {
  std::vector<int> kept;
  while (!group.empty()) {
    const std::vector<int> outermost = outermost_four(contacts, group);
    kept.insert(kept.end(), outermost.begin(), outermost.end());
    group = deeper_than(contacts, group, outermost, allowed);
  }
  return kept;
}

}  // namespace

std::vector<int> representative_contacts(std::span<const Contact> contacts, double allowed_overlap) {
  std::vector<std::vector<int>> groups;
  for (int i = 0; i < static_cast<int>(contacts.size()); ++i) {
    const auto alike = std::find_if(groups.begin(), groups.end(), [&](const std::vector<int>& group) {
      return contacts[group.front()].normal.dot(contacts[i].normal) > kAlike;
    });
    (alike == groups.end() ? groups.emplace_back() : *alike).push_back(i);
  }
  std::vector<int> kept;
  for (const std::vector<int>& group : groups) {
    const std::vector<int> some = group.size() > 4 ? spanning_contacts(contacts, group, allowed_overlap) : group;
    kept.insert(kept.end(), some.begin(), some.end());
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

}  // namespace griffith
