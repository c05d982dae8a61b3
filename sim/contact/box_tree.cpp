#include "sim/contact/box_tree.h"

#include <algorithm>
#include <utility>

namespace griffith::contact {

int BoxTree::take_node() {
  if (free_ < 0) {
    nodes_.emplace_back();
    return static_cast<int>(nodes_.size()) - 1;
  }
  const int node = free_;
  free_ = nodes_[node].parent;
  nodes_[node] = {};
  return node;
}

int BoxTree::insert(const Box& box, const Item& item) {
  const int leaf = take_node();
  nodes_[leaf].box = box;
  nodes_[leaf].item = item;
  if (root_ < 0) return root_ = leaf;
  const int sibling = best_sibling(box), parent = take_node(), above = nodes_[sibling].parent;
  nodes_[parent].parent = above;
  nodes_[parent].children[0] = sibling;
  nodes_[parent].children[1] = leaf;
  nodes_[sibling].parent = nodes_[leaf].parent = parent;
  if (above < 0) root_ = parent;
  if (above >= 0) nodes_[above].children[nodes_[above].children[1] == sibling] = parent;
  refit_above(leaf);
  return leaf;
}

void BoxTree::remove(int leaf) {
  const int parent = nodes_[leaf].parent;
  nodes_[leaf].parent = free_;
  free_ = leaf;
  if (parent < 0) return void(root_ = -1);
  const int sibling = nodes_[parent].children[nodes_[parent].children[0] == leaf], above = nodes_[parent].parent;
  nodes_[sibling].parent = above;
  if (above < 0) root_ = sibling;
  if (above >= 0) nodes_[above].children[nodes_[above].children[1] == parent] = sibling;
  nodes_[parent].parent = free_;
  free_ = parent;
  refit_above(sibling);
}

/// Returns the sibling whose boxes grow least.
int BoxTree::best_sibling(const Box& box) const {
  int node = root_;
  while (nodes_[node].children[0] >= 0) {
    const double grown = nodes_[node].box.with(box).area(), growth = grown - nodes_[node].box.area();
    double costs[2];
    for (int i = 0; i < 2; ++i) {
      const Node& child = nodes_[nodes_[node].children[i]];
      costs[i] = child.box.with(box).area() - (child.children[0] < 0 ? 0 : child.box.area()) + growth;
    }
    if (grown < costs[0] && grown < costs[1]) break;
    const bool shallower = nodes_[nodes_[node].children[1]].height < nodes_[nodes_[node].children[0]].height;
    node = nodes_[node].children[costs[1] < costs[0] || (costs[1] == costs[0] && shallower)];
  }
  return node;
}

void BoxTree::refit(int node) {
  Node& parent = nodes_[node];
  const Node &first = nodes_[parent.children[0]], &second = nodes_[parent.children[1]];
  parent.box = first.box.with(second.box);
  parent.height = 1 + std::max(first.height, second.height);
}

void BoxTree::refit_above(int node) {
  for (node = nodes_[node].parent; node >= 0; node = nodes_[node].parent) {
    refit(node);
    rotate(node);
  }
}

/// Exchanges a child with a grandchild on the other side if that makes the other child's box smaller, or the tree much
/// shallower.
void BoxTree::rotate(int node) {
  if (nodes_[node].height < 2) return;
  double best = 0;
  int best_side = -1, best_grandchild = 0;
  for (int side = 0; side < 2; ++side) {
    const int stays = nodes_[node].children[side], child = nodes_[node].children[1 - side];
    if (nodes_[child].children[0] < 0) continue;
    for (int i = 0; i < 2; ++i) {
      const Box& kept = nodes_[nodes_[child].children[1 - i]].box;
      const double gain = nodes_[child].box.area() - kept.with(nodes_[stays].box).area();
      if (gain <= best) continue;
      best = gain;
      best_side = side;
      best_grandchild = i;
    }
  }
  if (best_side < 0) return;
  const int child = nodes_[node].children[1 - best_side];
  std::swap(nodes_[node].children[best_side], nodes_[child].children[best_grandchild]);
  nodes_[nodes_[node].children[best_side]].parent = node;
  nodes_[nodes_[child].children[best_grandchild]].parent = child;
  refit(child);
  refit(node);
}

}  // namespace griffith::contact
