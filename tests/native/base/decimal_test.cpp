#include "base/decimal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>

#include "base/random.h"

namespace seamwise {
namespace {

std::string printed(const char* format, int digits, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, digits, value);
  return text;
}

TEST(Decimal, OfTheLeastNumber) {
  EXPECT_EQ(decimal(std::numeric_limits<std::int64_t>::min()), "-9223372036854775808");
}

TEST(Decimal, IsWhatTheCLibraryPrints) {
  for (const double value : {0.0,
                             -0.0,
                             1.0,
                             -1.0,
                             0.05,
                             0.15,
                             0.25,
                             0.35,
                             2.5,
                             0.125,
                             9.95,
                             99.95,
                             -0.04,
                             999999.5,
                             0.9999995,
                             1e-5,
                             1e-4,
                             0.00099999995,
                             123456.5,
                             1e10,
                             39.3701,
                             1e14,
                             0.30000000000000004,
                             20.125}) {
    for (int digits = 0; digits <= 6; ++digits)
      if (std::abs(value) * std::pow(10, digits) < 1e15) {
        EXPECT_EQ(fixed(value, digits), printed("%.*f", digits, value));
      }
    for (int digits = 1; digits <= 15; ++digits)
      EXPECT_EQ(significant(value, digits), printed("%.*g", digits, value));
  }
}

TEST(Decimal, IsWhatTheCLibraryPrintsOfNumbersOfAllSizes) {
  Random random(7);
  for (int k = 0; k < 200'000; ++k) {
    const double size = std::pow(10, 14 * random.uniform() - 5);
    const double value = (2 * random.uniform() - 1) * size;
    EXPECT_EQ(fixed(value, 1), printed("%.*f", 1, value));
    EXPECT_EQ(fixed(value, 2), printed("%.*f", 2, value));
    EXPECT_EQ(significant(value, 6), printed("%.*g", 6, value));
    EXPECT_EQ(significant(value, 8), printed("%.*g", 8, value));
    if (std::abs(value) > 1e-7) {
      EXPECT_EQ(significant(value, 15), printed("%.*g", 15, value));
    }
    // decimal ties, which doubles rarely represent exactly
    const double tie = std::round(value * 100) / 100 + 0.05;
    EXPECT_EQ(fixed(tie, 1), printed("%.*f", 1, tie));
  }
}

TEST(Decimal, OfExtremeNumbersIsTheirPowerOfTen) {
  EXPECT_EQ(significant(1e300, 6), "1e+300");
  EXPECT_EQ(significant(-2.5e-300, 6), "-2.5e-300");
  EXPECT_EQ(significant(5e-324, 6), "4.94066e-324");
  EXPECT_EQ(significant(1.7976931348623157e308, 6), "1.79769e+308");
  EXPECT_EQ(fixed(1e300, 1), "1e+300");
  EXPECT_EQ(significant(HUGE_VAL, 6), "inf");
}

}  // namespace
}  // namespace seamwise
