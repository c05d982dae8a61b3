#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sim/core/number_text.h"
#include "ui/model/quantity_parser.h"

namespace griffith::ui {
namespace {

TEST(Units, ValuesReadLikeEngineersWriteThem) {
  EXPECT_EQ(format_quantity(15e9, "Pa"), "15 GPa");
  EXPECT_EQ(format_quantity(2.5e6, "Pa"), "2.5 MPa");
  EXPECT_EQ(format_quantity(0.2, "m"), "200 mm");
  EXPECT_EQ(format_quantity(0.139, "m", 2), "139 mm") << "no exponent, whatever number of digits";
  EXPECT_EQ(format_quantity(1900, "kg/m³"), "1900 kg/m³");
  EXPECT_EQ(format_quantity(7e5, "Pa·√m"), "700 kPa·√m");
  EXPECT_EQ(format_quantity(0.18, ""), "0.18");
  EXPECT_EQ(format_quantity(0.5, "-"), "0.5");
  EXPECT_EQ(format_quantity(0, "Pa"), "0 Pa");
  EXPECT_EQ(format_quantity(-3e6, "Pa"), "-3 MPa");
}

TEST(Units, TypedTextIsReadWithPrefixAndUnit) {
  EXPECT_DOUBLE_EQ(parse_quantity("20 GPa", "Pa").value(), 20e9);
  EXPECT_DOUBLE_EQ(parse_quantity(" 20G ", "Pa").value(), 20e9);
  EXPECT_DOUBLE_EQ(parse_quantity("2e10 Pa", "Pa").value(), 2e10);
  EXPECT_DOUBLE_EQ(parse_quantity("20", "Pa").value(), 20);
  EXPECT_DOUBLE_EQ(parse_quantity("5 m", "m").value(), 5);
  EXPECT_DOUBLE_EQ(parse_quantity("5 mm", "m").value(), 5e-3);
  EXPECT_DOUBLE_EQ(parse_quantity("+3 uN", "N").value(), 3e-6);
}

TEST(Units, ABareNumberIsInTheUnitShown) {
  const SiPrefix milli = si_prefix(0.01, "m"), mega = si_prefix(2e6, "Pa");
  EXPECT_EQ(parse_quantity("604", "m", milli), 0.604);
  EXPECT_EQ(parse_quantity("9", "m", milli), 0.009);
  EXPECT_EQ(parse_quantity("3", "Pa", mega), 3e6);
  EXPECT_EQ(parse_quantity("3 Pa", "Pa", mega), 3);
  EXPECT_EQ(parse_quantity("0.5 m", "m", milli), 0.5);
}

TEST(Units, ArithmeticMixesUnits) {
  const SiPrefix milli = si_prefix(0.01, "m");
  EXPECT_DOUBLE_EQ(parse_quantity("2*30+1 mm", "m", milli).value(), 0.061);
  EXPECT_DOUBLE_EQ(parse_quantity("2*30 + 1 m + 1 mm", "m", milli).value(), 1.061);
  EXPECT_DOUBLE_EQ(parse_quantity("2*30+1", "m", milli).value(), 0.061);
  EXPECT_DOUBLE_EQ(parse_quantity("(4-1) cm / 2", "m").value(), 0.015);
  EXPECT_DOUBLE_EQ(parse_quantity("1 m / 3", "m", milli).value(), 1.0 / 3);
  EXPECT_DOUBLE_EQ(parse_quantity("3 m / 1 mm", "-").value_or(0), 0) << "no lengths in a ratio";
  EXPECT_DOUBLE_EQ(parse_quantity("2 - -3", "").value(), 5);
  EXPECT_DOUBLE_EQ(parse_quantity("-(1+2)*2", "").value(), -6);
  EXPECT_DOUBLE_EQ(parse_quantity("36 km/h", "m/s").value(), 10);
  EXPECT_DOUBLE_EQ(parse_quantity("3 m/s / 2", "m/s").value(), 1.5);
  EXPECT_DOUBLE_EQ(parse_quantity("2.5 g/cm3", "kg/m³").value(), 2500);
  for (const char* text : {"1 m * 2 m", "1 / 2 m + 1 mm", "1/0", "(1", "1)", "2*", "1 2", "mm", "1 m m"})
    EXPECT_FALSE(parse_quantity(text, "m", milli)) << text;
}

TEST(Units, AUnitAtTheEndIsThatOfAllNumbers) {
  const SiPrefix milli = si_prefix(0.01, "m");
  EXPECT_DOUBLE_EQ(parse_quantity("2*30+1 mm", "m").value(), 0.061);
  EXPECT_DOUBLE_EQ(parse_quantity("0.7+0.01 m ", "m", milli).value(), 0.71);
  EXPECT_DOUBLE_EQ(parse_quantity("1/2 in", "m", milli).value(), 0.0127);
  EXPECT_DOUBLE_EQ(parse_quantity("(1+2)*2 cm", "m", milli).value(), 0.06);
}

TEST(Units, EveryUnitCanBeTyped) {
  for (const char* text :
       {"1.2 MPa sqrt(m)", "1.2 MPa*sqrt(m)", "1.2 MPa m^0.5", "1.2 MPa.m^0.5", "1.2MPa m^(1/2)", "1.2 M"})
    EXPECT_DOUBLE_EQ(parse_quantity(text, "Pa·√m").value_or(0), 1.2e6) << text;
  EXPECT_EQ(typed_unit("Pa·√m", si_prefix(1e6, "Pa")), "MPa sqrt(m)");
  EXPECT_DOUBLE_EQ(parse_quantity("30 N/mm2", "Pa").value(), 30e6);
  EXPECT_DOUBLE_EQ(parse_quantity("22 %", "").value(), 0.22);
  EXPECT_DOUBLE_EQ(parse_quantity("1 g/cm^3", "kg/m³").value(), 1000);
}

TEST(Units, TextOfAnotherKindIsNotRead) {
  for (const char* text : {"", "abc", "20 kg", "1e999", "nan", "inf", "20 GPam", "--3"}) {
    EXPECT_FALSE(parse_quantity(text, "Pa")) << text;
  }
  EXPECT_FALSE(parse_quantity("3 k", "kg/m³"));
}

TEST(Units, WhatIsShownReadsBackAsTheSameValue) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> exponent(-12, 15);
  for (int i = 0; i < 5000; ++i) {
    const double value = std::pow(10, exponent(random)) * (random() % 2 == 0 ? 1 : -1);
    for (const char* unit : {"Pa", "N", "m", "kg/m³", "m/s", "", "Pa·√m"}) {
      const std::string text = format_quantity(value, unit, 15);
      const auto parsed = parse_quantity(text, unit);
      ASSERT_TRUE(parsed) << text;
      ASSERT_NEAR(*parsed, value, 1e-3 * std::abs(value)) << text;
    }
  }
}

TEST(Units, MantissaLiesBetweenOneAndAThousand) {
  for (double value = 1.0001e-9; value < 1e15; value *= 3.7) {
    const double scaled = value / si_prefix(value, "Pa").factor;
    EXPECT_GE(scaled, 1);
    EXPECT_LT(scaled, value < 1e15 ? 1000 : 1e6);
  }
}

TEST(Units, DegreesStandAtTheirNumber) {
  EXPECT_EQ(format_quantity(15, "°"), "15°");
  EXPECT_EQ(parse_quantity("15°", "°"), 15);
  EXPECT_EQ(parse_quantity("15 °", "°"), 15);
}

TEST(CountText, GroupsByThree) {
  EXPECT_EQ(count_text(0), "0");
  EXPECT_EQ(count_text(999), "999");
  EXPECT_EQ(count_text(8012), "8,012");
  EXPECT_EQ(count_text(1234567), "1,234,567");
  EXPECT_EQ(count_text(-123), "-123");
  EXPECT_EQ(count_text(-1234), "-1,234");
}

TEST(DirectionText, HasTwoDigits) { EXPECT_EQ(direction_text(Vec3(0.6, -0.8, 0)), "0.60, -0.80, 0.00"); }

}  // namespace
}  // namespace griffith::ui
