#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace griffith::ui {

/// Arrangement of the sections of the side panels, by name.
struct SectionOrder {
  std::vector<std::string> left = {"outliner", "handles", "entry", "materials", "scene", "grab", "push", "projectile"};
  std::vector<std::string> right = {"view", "symbol", "inspector", "statistics"};
  std::set<std::string> folded;  ///< sections of which only the title is shown

  std::vector<std::string>& side(bool is_left) { return is_left ? left : right; }
  const std::vector<std::string>& side(bool is_left) const { return is_left ? left : right; }
  bool operator==(const SectionOrder&) const = default;
};

/// Moves a section to a side, before another section there; to its end if that is not there.
void move_section(SectionOrder& order, const std::string& name, bool to_left, std::string_view before);

/// True if each section is on one side once, and nothing else is.
bool is_complete(const SectionOrder& order);

}  // namespace griffith::ui
