#include "ui/model/edit_history.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace griffith::ui {
namespace {

void set_gravity(EditHistory& history, const std::string& label, double value) {
  history.change(label, [value](Scene& scene) { scene.gravity.y() = value; });
}

TEST(EditHistory, ManyChangesOfOneGestureAreOneEntry) {
  EditHistory history({});
  for (int i = 1; i <= 50; ++i) set_gravity(history, "Set gravity", -i);
  history.finish();
  ASSERT_EQ(history.entries().size(), 1u);
  EXPECT_EQ(history.entries()[0].before.gravity.y(), -9.81);
  EXPECT_EQ(history.entries()[0].after.gravity.y(), -50);
  history.undo();
  EXPECT_EQ(history.scene(), Scene());
}

TEST(EditHistory, AnotherLabelBeginsAnotherEntry) {
  EditHistory history({});
  set_gravity(history, "a", -1);
  set_gravity(history, "b", -2);
  history.finish();
  ASSERT_EQ(history.entries().size(), 2u);
  history.undo();
  EXPECT_EQ(history.scene().gravity.y(), -1);
}

TEST(EditHistory, GestureThatEndsWhereItBeganLeavesNothing) {
  EditHistory history({});
  set_gravity(history, "a", -1);
  set_gravity(history, "a", -9.81);
  history.finish();
  EXPECT_FALSE(history.can_undo());
  EXPECT_FALSE(history.modified());
}

TEST(EditHistory, SavedStateIsRememberedAcrossUndo) {
  EditHistory history({});
  set_gravity(history, "a", -1);
  history.finish();
  history.mark_saved();
  EXPECT_FALSE(history.modified());
  history.undo();
  EXPECT_TRUE(history.modified());
  history.redo();
  EXPECT_FALSE(history.modified());
}

TEST(EditHistory, GoesToTheNearestWantedScene) {
  EditHistory history({});
  for (int i = 1; i <= 9; ++i) {
    set_gravity(history, std::to_string(i), -i);
    history.finish();
  }
  const auto go_to = [&](std::vector<double> wanted) {
    return history.go_to([&](const Scene& scene) { return std::ranges::count(wanted, scene.gravity.y()) > 0; });
  };
  EXPECT_TRUE(go_to({-9}));
  EXPECT_EQ(history.scene().gravity.y(), -9);
  EXPECT_TRUE(go_to({-2, -5, -9.81}));
  EXPECT_EQ(history.scene().gravity.y(), -5);
  EXPECT_TRUE(go_to({-3, -6, -8}));
  EXPECT_EQ(history.scene().gravity.y(), -6);
  EXPECT_TRUE(go_to({-4, -8})) << "both are as near";
  EXPECT_EQ(history.scene().gravity.y(), -4);
  EXPECT_TRUE(go_to({-9.81}));
  EXPECT_FALSE(history.can_undo());
  EXPECT_FALSE(go_to({-20}));
  EXPECT_EQ(history.scene(), Scene());
  EXPECT_TRUE(go_to({-9}));
  EXPECT_FALSE(history.can_redo());
}

/// The history against the simplest model of one: a list of all states and a place in it.
TEST(EditHistory, FollowsAModelThroughRandomUse) {
  std::mt19937 random(7);
  EditHistory history({});
  std::vector<double> states = {history.scene().gravity.y()};
  std::size_t place = 0;
  for (int i = 0; i < 5000; ++i) {
    switch (random() % 3) {
      case 0: {
        const double value = -static_cast<double>(random() % 1000) - 10;
        if (value == states[place]) break;
        set_gravity(history, "edit " + std::to_string(i), value);
        history.finish();
        states.resize(++place);
        states.push_back(value);
        break;
      }
      case 1:
        history.undo();
        if (place > 0) --place;
        break;
      case 2:
        history.redo();
        if (place + 1 < states.size()) ++place;
        break;
    }
    ASSERT_EQ(history.scene().gravity.y(), states[place]);
    ASSERT_EQ(history.can_undo(), place > 0);
    ASSERT_EQ(history.can_redo(), place + 1 < states.size());
  }
}

}  // namespace
}  // namespace griffith::ui
