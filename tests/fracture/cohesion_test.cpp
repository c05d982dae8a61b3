#include "sim/fracture/cohesion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace griffith {
namespace {

constexpr Bond kWhole = {.force = 3e3, .critical = 2e-5};  // takes 0.03 J

/// Mass on a bond, moved by leapfrog: the work of the bond on it, and the bond in the end.
struct TornMass {
  double mass = 0.1, speed = 0, place = 0, work = 0;
  Bond bond = kWhole;

  void step(double dt, double load) {
    const double before = speed;
    speed += dt * load / mass;
    place += dt * speed;
    const double force = pull(bond, std::abs(place), dt * dt / mass);
    speed -= dt * force / mass;
    place -= dt * dt * force / mass;
    work += 0.5 * dt * force * (before + speed);
  }
};

TEST(Cohesion, ABondTornApartTakesItsEnergyWhateverTheStep) {
  for (const double load : {1.01 * kWhole.force, 2 * kWhole.force, 10 * kWhole.force})
    for (const double steps : {8.0, 50.0, 400.0}) {
      TornMass torn;
      const double time = std::sqrt(2 * kWhole.critical * torn.mass / load);
      while (torn.bond.holds()) torn.step(time / steps, load);
      EXPECT_NEAR(torn.work / kWhole.energy_left(), 1, 3 / steps) << load << " N, " << steps << " steps";
    }
}

TEST(Cohesion, ABondHoldsALoadBelowItsForceAndTakesNothing) {
  TornMass held;
  for (int i = 0; i < 1000; ++i) held.step(1e-5, 0.99 * kWhole.force);
  EXPECT_EQ(held.bond.opening, 0);
  EXPECT_NEAR(held.work, 0, 1e-12);
}

TEST(Cohesion, WhatABondHasTakenIsSpent) {
  Bond bond = kWhole;
  const double compliance = 1e-12;
  EXPECT_GT(pull(bond, 1e-5, compliance), 0);
  const Bond opened = bond;
  EXPECT_EQ(pull(bond, 0.5 * opened.opening, compliance), 0) << "it does not act on what closes";
  EXPECT_EQ(bond.opening, opened.opening);
  EXPECT_NEAR(pull(bond, 1.5 * opened.opening, compliance), kWhole.force * (1 - opened.opening / kWhole.critical), 1);
  EXPECT_LT(bond.energy_left(), opened.energy_left());
}

TEST(Cohesion, TheMeanForceOfAWayTakesTheEnergyThatTheBondLoses) {
  for (const double before : {0.0, 0.4, 0.9})
    for (const double way : {0.01, 0.3, 1.0, 20.0}) {
      Bond bond = kWhole;
      open(bond, before * kWhole.critical);
      const double left = bond.energy_left(), opening = (before + way) * kWhole.critical;
      const double work = mean_force(bond, opening) * way * kWhole.critical;
      EXPECT_NEAR(open(bond, opening), work, 1e-12 * kWhole.energy_left());
      EXPECT_NEAR(left - (bond.holds() ? bond.energy_left() : 0), work, 1e-12 * kWhole.energy_left());
      EXPECT_EQ(bond.holds(), before + way < 1);
    }
}

TEST(Cohesion, TheMeanForceOfAShortWayIsTheStrength) {
  Bond bond = kWhole;
  open(bond, 0.25 * kWhole.critical);
  EXPECT_NEAR(bond.strength(), 0.75 * kWhole.force, 1e-12 * kWhole.force);
  EXPECT_EQ(mean_force(bond, 0.1 * kWhole.critical), bond.strength()) << "it does not act on what closes";
  EXPECT_NEAR(mean_force(bond, 0.250001 * kWhole.critical), bond.strength(), 1e-6 * kWhole.force);
}

TEST(Cohesion, AFastMotionBreaksABondForNoMoreThanItsEnergy) {
  for (const double opening : {1e-4, 1e-2, 1.0}) {
    Bond bond = kWhole;
    const double compliance = 1e-10;
    const double force = pull(bond, opening, compliance);
    EXPECT_FALSE(bond.holds());
    EXPECT_LE(0.5 * force * (opening - compliance * force), (1 + 1e-9) * kWhole.energy_left()) << opening;
  }
}

}  // namespace
}  // namespace griffith
