#pragma once

#include <vector>

#include "sim/core/linear_algebra.h"

namespace griffith::contact {

/// Axis-parallel box [m].
struct Box {
  Vec3 low, high;
  bool holds(const Box& other) const {
    return (low.array() <= other.low.array()).all() && (high.array() >= other.high.array()).all();
  }
  bool meets(const Box& other) const {
    return low.x() <= other.high.x() && other.low.x() <= high.x() && low.y() <= other.high.y() &&
           other.low.y() <= high.y() && low.z() <= other.high.z() && other.low.z() <= high.z();
  }
  Box with(const Box& other) const { return {low.cwiseMin(other.low), high.cwiseMax(other.high)}; }
  /// Returns half of its surface [m²].
  double area() const {
    const Vec3 size = high - low;
    return size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
  }
};

/// Dynamic binary tree of boxes: a new leaf goes to where the boxes above it grow least, and the tree is rotated if
/// that makes them smaller (as in Box2D). A value: a copy gives the same answers.
class BoxTree {
 public:
  /// Convex part of an object: the content of a leaf.
  struct Item {
    int object, part;
  };

  /// Returns the leaf; it stays until removed.
  int insert(const Box& box, const Item& item);
  void remove(int leaf);
  const Box& box(int leaf) const { return nodes_[leaf].box; }

  /// Calls visit(item) for all leaves whose boxes meet `box`, in an order that depends on the history.
  template <class Visit>
  void for_each(const Box& box, Visit visit) const {
    for (int node = root_; node >= 0;) {
      const bool meets = nodes_[node].box.meets(box), is_leaf = nodes_[node].children[0] < 0;
      if (meets && is_leaf) visit(nodes_[node].item);
      node = meets && !is_leaf ? nodes_[node].children[0] : after(node);
    }
  }

  std::size_t memory() const { return nodes_.capacity() * sizeof(Node); }

 private:
  struct Node {
    Box box;
    int parent = -1;
    int children[2] = {-1, -1};  // none of a leaf
    Item item = {-1, -1};
    int height = 0;
  };

  /// Returns the next node after those below this one; -1 after the last.
  int after(int node) const {
    while (nodes_[node].parent >= 0 && nodes_[nodes_[node].parent].children[1] == node) node = nodes_[node].parent;
    return nodes_[node].parent < 0 ? -1 : nodes_[nodes_[node].parent].children[1];
  }
  int take_node();
  int best_sibling(const Box& box) const;
  void refit(int node);
  void refit_above(int node);
  void rotate(int node);

  std::vector<Node> nodes_;
  int root_ = -1, free_ = -1;  // free ones are linked by `parent`
};

}  // namespace griffith::contact
