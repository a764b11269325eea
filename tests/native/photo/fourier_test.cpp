#include "photo/base/fourier.h"

#include <gtest/gtest.h>

#include "base/random.h"
#include "geometry/vec2.h"

namespace seamwise {
namespace {

std::vector<ComplexFloat> anyNumbers(int count) {
  Random random(7);
  std::vector<ComplexFloat> numbers(count);
  for (ComplexFloat& number : numbers) {
    number = {static_cast<float>(random.uniform()), static_cast<float>(random.uniform())};
  }
  return numbers;
}

std::complex<double> summed(const std::vector<ComplexFloat>& line, int l, bool inverse) {
  std::complex<double> sum = 0;
  const int n = static_cast<int>(line.size());
  for (int k = 0; k < n; ++k) {
    const std::complex<double> number = line[k];
    sum += number * std::polar(1.0, (inverse ? 2 : -2) * kPi * k * l / n);
  }
  return sum;
}

TEST(Fourier, IsTheSumOverALineOfAnyLength) {
  for (const int n : {1, 2, 3, 4, 5, 7, 8, 12, 30, 49, 60, 94, 120}) {
    for (const bool inverse : {false, true}) {
      const std::vector<ComplexFloat> line = anyNumbers(n);
      std::vector<ComplexFloat> transformed = line;
      transformLines(transformed, {1, n, n, 1}, inverse);
      for (int l = 0; l < n; ++l) {
        const std::complex<double> exact = summed(line, l, inverse);
        EXPECT_NEAR(transformed[l].real(), exact.real(), 1e-5 * n) << n << " " << l;
        EXPECT_NEAR(transformed[l].imag(), exact.imag(), 1e-5 * n) << n << " " << l;
      }
    }
  }
}

TEST(Fourier, TransformsEveryColumnAndNothingBeside) {
  constexpr int kColumns = 7, kRows = 6, kWidth = 9;  // two columns stay unchanged
  const std::vector<ComplexFloat> plane = anyNumbers(kWidth * kRows);
  std::vector<ComplexFloat> transformed = plane;
  transformLines(transformed, {kColumns, kRows, 1, kWidth});
  for (int x = 0; x < kWidth; ++x) {
    std::vector<ComplexFloat> column;
    for (int y = 0; y < kRows; ++y) column.push_back(plane[y * kWidth + x]);
    for (int y = 0; y < kRows; ++y) {
      const std::complex<double> wanted =
          x < kColumns ? summed(column, y, false) : std::complex<double>(column[y]);
      EXPECT_NEAR(transformed[y * kWidth + x].real(), wanted.real(), 1e-5);
      EXPECT_NEAR(transformed[y * kWidth + x].imag(), wanted.imag(), 1e-5);
    }
  }
}

}  // namespace
}  // namespace seamwise
