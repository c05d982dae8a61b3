#include "sim/contact/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace griffith {
namespace {

using contact::Box;
using contact::BoxTree;

/// Boxes that come, go and move, in a tree and in a list.
class Crowd {
 public:
  explicit Crowd(unsigned seed) : random_(seed) {}

  void change() {
    const double choice = uniform_(random_);
    if (choice < 0.3 || boxes_.empty()) return add();
    const std::size_t i = index();
    tree_.remove(leaves_[i]);
    if (choice < 0.4) {
      boxes_.erase(boxes_.begin() + static_cast<std::ptrdiff_t>(i));
      leaves_.erase(leaves_.begin() + static_cast<std::ptrdiff_t>(i));
      names_.erase(names_.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      boxes_[i] = choice < 0.5 ? boxes_[index()] : random_box();  // many lie in the same place
      leaves_[i] = tree_.insert(boxes_[i], {names_[i], 0});
    }
  }

  Box random_box() {
    const Vec3 low(uniform_(random_), uniform_(random_), uniform_(random_));
    return {low, low + 0.2 * Vec3(uniform_(random_), uniform_(random_), uniform_(random_))};
  }

  std::vector<int> in_tree(const BoxTree& tree, const Box& box) const {
    std::vector<int> found;
    tree.for_each(box, [&](const BoxTree::Item& item) { found.push_back(item.object); });
    std::ranges::sort(found);
    return found;
  }

  std::vector<int> in_list(const Box& box) const {
    std::vector<int> found;
    for (std::size_t i = 0; i < boxes_.size(); ++i)
      if (boxes_[i].meets(box)) found.push_back(names_[i]);
    std::ranges::sort(found);
    return found;
  }

  const BoxTree& tree() const { return tree_; }

 private:
  void add() {
    boxes_.push_back(random_box());
    names_.push_back(next_++);
    leaves_.push_back(tree_.insert(boxes_.back(), {names_.back(), 0}));
  }
  std::size_t index() { return random_() % boxes_.size(); }

  std::mt19937 random_;
  std::uniform_real_distribution<double> uniform_{0, 1};
  BoxTree tree_;
  std::vector<Box> boxes_;
  std::vector<int> leaves_, names_;
  int next_ = 0;
};

TEST(BoxTree, FindsWhatAListFindsWhateverComesAndGoes) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    Crowd crowd(seed);
    for (int i = 0; i < 1500; ++i) {
      crowd.change();
      if (i % 10 > 0) continue;
      const Box box = crowd.random_box();
      ASSERT_EQ(crowd.in_tree(crowd.tree(), box), crowd.in_list(box)) << seed << ' ' << i;
    }
    const BoxTree copy = crowd.tree();
    const Box box = crowd.random_box();
    EXPECT_EQ(crowd.in_tree(copy, box), crowd.in_list(box));
  }
}

TEST(BoxTree, TakesAnyNumberOfBoxesInOnePlace) {
  BoxTree tree;
  const Box box{Vec3::Zero(), Vec3::Ones()};
  std::vector<int> leaves;
  for (int i = 0; i < 2000; ++i) leaves.push_back(tree.insert(box, {i, 0}));
  int count = 0;
  tree.for_each(box, [&](const BoxTree::Item&) { ++count; });
  EXPECT_EQ(count, 2000);
  for (const int leaf : leaves) tree.remove(leaf);
  tree.for_each(box, [&](const BoxTree::Item&) { ADD_FAILURE() << "nothing is left"; });
}

}  // namespace
}  // namespace griffith
