#include "sim/contact/contact_reduction.h"

#include <algorithm>
#include <cmath>

namespace griffith {
namespace {

constexpr double kAlike = 0.95;  // cosine of the angle between two normals

/// Returns the index in `group` with the largest value, the first of several.
template <class Value>
int best_of(const std::vector<int>& group, Value value) {
  return *std::max_element(group.begin(), group.end(), [&](int a, int b) { return value(a) < value(b); });
}

/// True if a contact is deeper than all of others by more than a small share of the distances between them, and than
/// is allowed [m].
bool is_deeper(std::span<const Contact> contacts, int contact, const std::vector<int>& others, double allowed) {
  constexpr double kMargin = 1e-3;
  return std::ranges::all_of(others, [&](int i) {
    const double apart = (contacts[i].position - contacts[contact].position).norm();
    return contacts[contact].distance < std::min(contacts[i].distance, -allowed) - kMargin * apart;
  });
}

/// Returns the deepest contact, without which a rounded side would sink in between the others, and the outermost along
/// two axes of the contact plane. The choice changes little from step to step, so that the last impulses stay a good
/// guess.
std::vector<int> spanning_contacts(std::span<const Contact> contacts, const std::vector<int>& group, double allowed) {
  const Vec3 normal = contacts[group.front()].normal, first = normal.unitOrthogonal(), second = normal.cross(first);
  const int deepest = best_of(group, [&](int i) { return -contacts[i].distance; });
  std::vector<int> kept;
  for (const Vec3& direction :
       {Vec3(first + second), Vec3(first - second), Vec3(-first - second), Vec3(second - first)})
    kept.push_back(best_of(group, [&](int i) { return direction.dot(contacts[i].position); }));
  if (is_deeper(contacts, deepest, kept, allowed)) kept.push_back(deepest);
  std::sort(kept.begin(), kept.end());
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
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
