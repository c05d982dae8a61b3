#include "ui/model/energy_share.h"

#include <gtest/gtest.h>

#include <vector>

#include "ui/model/overlap.h"

namespace griffith::ui {
namespace {

/// A block of a material, of that mass.
class BlockFrame {
 public:
  explicit BlockFrame(double mass, double width = 0.006) {
    bodies_[0].mass = mass;
    corners_ = {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, width)}};
    bodies_[0].collision_parts = corners_;
    frame.bodies = bodies_;
    frame.materials = materials_;
  }
  /// Lets it touch the ground under a normal, with an overlap [m].
  void touch(const Vec3& normal, double overlap) {
    contacts_ = {{BodyId(0), BodyId(), Vec3::Zero(), normal, normal}};
    frame.contacts = contacts_;
    frame.report.max_penetration = overlap;
  }
  void turn(const Quat& orientation) { bodies_[0].orientation = orientation; }

  Frame frame;

 private:
  std::vector<BodyView> bodies_ = std::vector<BodyView>(1);
  std::vector<Material> materials_ = std::vector<Material>(1);
  std::vector<std::vector<Vec3>> corners_;
  std::vector<ContactView> contacts_;
};

TEST(EnergyShare, RoundingIsNothingHoweverSmallTheWhole) {
  const Vec3 gravity(0, -9.81, 0);
  for (const double mass : {1e-6, 1.0, 1e6}) {
    const double size = std::cbrt(mass / 1000), noise = energy_noise(BlockFrame(mass).frame, gravity, size);
    const double fall = mass * gravity.norm() * size;  // over its own size
    for (const double energy : {1e-14 * fall, -1e-14 * fall}) {
      const EnergyShare share = energy_share(energy, std::abs(energy), noise);
      EXPECT_EQ(share.energy, 0);
      EXPECT_EQ(share.fraction, 0) << "no bar";
    }
    EXPECT_EQ(energy_share(1e-6 * fall, 1e-6 * fall, noise).energy, 1e-6 * fall) << "but a fall of a micron counts";
    EXPECT_EQ(energy_share(1e-6 * fall, 1e-6 * fall, noise).fraction, 1);
  }
}

TEST(EnergyShare, BarsAreSharesOfTheWhole) {
  EXPECT_EQ(energy_share(3, 4, 1e-9).fraction, 0.75);
  EXPECT_EQ(energy_share(5, 4, 1e-9).fraction, 1);
  EXPECT_EQ(energy_share(-3, 4, 1e-9).energy, -3);
  EXPECT_EQ(energy_share(-3, 4, 1e-9).fraction, 0);
  EXPECT_EQ(energy_share(1e-13, 4, 1e-30).energy, 0);
  EXPECT_EQ(energy_share(0, 0, 0).fraction, 0);
  EXPECT_EQ(energy_share(std::nan(""), 4, 1e-9).energy, 0);
}

TEST(DeepOverlap, IsOneThatIsLargeBesideWhatTouches) {
  BlockFrame pane(1);
  EXPECT_FALSE(deep_overlap(pane.frame));
  pane.touch(Vec3::UnitZ(), 1e-4);
  EXPECT_FALSE(deep_overlap(pane.frame));
  pane.touch(Vec3::UnitZ(), 0.015);
  ASSERT_TRUE(deep_overlap(pane.frame));
  EXPECT_DOUBLE_EQ(deep_overlap(pane.frame)->width, 0.006);
  const std::string text = text_of(*deep_overlap(pane.frame));
  EXPECT_NE(text.find("15 mm"), std::string::npos) << text;
  EXPECT_NE(text.find("6 mm"), std::string::npos) << text;
  EXPECT_NE(text.find("shorter time step"), std::string::npos) << text;
  pane.touch(Vec3::UnitX(), 0.015);
  EXPECT_FALSE(deep_overlap(pane.frame)) << "along its meter that is little";
  pane.turn(Quat(Eigen::AngleAxisd(M_PI / 2, Vec3::UnitY())));
  EXPECT_TRUE(deep_overlap(pane.frame)) << "it has turned";
}

}  // namespace
}  // namespace griffith::ui
