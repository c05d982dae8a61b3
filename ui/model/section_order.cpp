#include "ui/model/section_order.h"

#include <algorithm>

namespace griffith::ui {
namespace {

std::vector<std::string> sorted_names(const SectionOrder& order) {
  std::vector<std::string> names = order.left;
  names.insert(names.end(), order.right.begin(), order.right.end());
  std::ranges::sort(names);
  return names;
}

}  // namespace

void move_section(SectionOrder& order, const std::string& name, bool to_left, std::string_view before) {
  if (name == before) return;
  std::erase(order.left, name);
  std::erase(order.right, name);
  std::vector<std::string>& side = order.side(to_left);
  side.insert(std::ranges::find(side, before), name);
}

bool is_complete(const SectionOrder& order) {
  const std::vector<std::string> names = sorted_names(order), all = sorted_names({});
  return names == all && std::ranges::includes(all, order.folded);
}

}  // namespace griffith::ui
