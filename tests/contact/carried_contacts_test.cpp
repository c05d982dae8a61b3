#include <gtest/gtest.h>

#include "tests/contact/bodies.h"

namespace griffith {
namespace {

using namespace testing;

/// Two boxes that touch face to face along y, and how they lie now.
struct TouchingBoxes {
  explicit TouchingBoxes(const std::array<RigidState, 2>& states) : world(Vec3::Zero()) {
    for (const RigidState& state : states)
      world.add_proxy(box_parts(Vec3(1, 0.4, 0.7)), box_mass(Vec3(1, 0.4, 0.7), 5), Mobility::free, state, {0.5, 0});
    world.detect();
  }
  ContactWorld world;
};

/// The contacts of boxes that were followed to a place are those of boxes that are put there.
void expect_same(const ContactWorld& followed, const ContactWorld& fresh, double tolerance) {
  ASSERT_EQ(followed.contacts().size(), fresh.contacts().size());
  for (const Contact& contact : followed.contacts()) {
    double nearest = std::numeric_limits<double>::infinity();
    const Contact* same = nullptr;
    for (const Contact& other : fresh.contacts())
      if (const double distance = (other.position - contact.position).norm(); distance < nearest) {
        nearest = distance;
        same = &other;
      }
    EXPECT_LT(nearest, tolerance);
    EXPECT_NEAR(contact.distance, same->distance, 0.02 * tolerance);
    EXPECT_LT((contact.normal - same->normal).norm(), tolerance);
  }
}

TEST(CarriedContacts, FollowAPairThatTurnsTogether) {
  const Vec3 axis = Vec3(1, -2, 0.5).normalized();
  std::array<RigidState, 2> states = {at(Vec3(0, -0.2, 0)), at(Vec3(0.2, 0.2003, 0.1))};
  TouchingBoxes followed(states);
  ASSERT_EQ(followed.world.contacts().size(), 4u);
  for (int step = 1; step <= 40; ++step) {
    const Quat turn(Eigen::AngleAxisd(0.05 * step, axis));
    std::array<RigidState, 2> now = states;
    for (std::size_t i = 0; i < now.size(); ++i) {
      now[i].pose.translation = turn * states[i].pose.translation + Vec3(0.1, 0, 0) * step;
      now[i].pose.rotation = turn;
      followed.world.set_state(ProxyId(static_cast<int>(i)), now[i]);
    }
    followed.world.detect();
    expect_same(followed.world, TouchingBoxes(now).world, 1e-4);
  }
}

TEST(CarriedContacts, SeeThePairPartAndShift) {
  const double radius = 0.5 * Vec3(1, 0.4, 0.7).norm(), reach = 0.02 * radius;
  std::array<RigidState, 2> states = {at(Vec3(0, -0.2, 0)), at(Vec3(0, 0.2, 0))};
  TouchingBoxes followed(states);
  for (int step = 1; step <= 60; ++step) {
    states[1].pose.translation += Vec3(0.04, 0.02, -0.03) * reach;  // below what makes them be looked at again
    states[1].pose.rotation = Quat(Eigen::AngleAxisd(2e-5 * step, Vec3::UnitX()));
    followed.world.set_state(ProxyId(1), states[1]);
    followed.world.detect();
    const TouchingBoxes fresh(states);
    if (fresh.world.contacts().size() < 4 || step > 40) continue;  // some are at the end of the reach
    expect_same(followed.world, fresh.world, 0.25 * reach);
  }
  EXPECT_EQ(followed.world.contacts().size(), 0u) << "a gap of 1.2 times the reach";
}

}  // namespace
}  // namespace griffith
