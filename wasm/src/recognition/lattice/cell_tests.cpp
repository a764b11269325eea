#include "recognition/lattice/cell_tests.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace seamwise {
namespace {

using Pixel = ChannelImage::Pixel;

constexpr int kPlaces = 12;  // along a cell

float energy(const Pixel& pixel) {
  return pixel[0] * pixel[0] + pixel[1] * pixel[1] + pixel[2] * pixel[2];
}

int modulo(int a, int n) { return (a % n + n) % n; }

/// Which of the classes of the larger cell a cell belongs to.
int classOf(const std::array<int, 2>& cell, const Mat2& larger) {
  const int a = static_cast<int>(larger(0, 0)), b = static_cast<int>(larger(0, 1));
  const int d = static_cast<int>(larger(1, 1));
  const int row = modulo(cell[1], d);
  return row * a + modulo(cell[0] - b * ((cell[1] - row) / d), a);
}

struct PlaceSums {
  double between = 0, within = 0, between_freedom = 0, within_freedom = 0;
};

}  // namespace

std::vector<Mat2> largerCells(int index) {
  std::vector<Mat2> cells;
  for (int a = 1; a <= index; ++a) {
    if (index % a != 0) continue;
    for (int b = 0; b < a; ++b) cells.push_back((Mat2() << a, b, 0, index / a).finished());
  }
  return cells;
}

SplitEvidence splitEvidence(const Copies& copies, const Mat2& larger) {
  const int classes = static_cast<int>(std::lround(larger.determinant()));
  const std::size_t samples = copies.samples();
  std::vector<float> sums(4 * samples * classes), counts(samples * classes);
  std::vector<int> class_of(copies.cells.size());
  for (std::size_t c = 0; c < copies.cells.size(); ++c)
    class_of[c] = classOf(copies.cells[c], larger);
  std::size_t at = 0;
  std::vector<float> squares(samples);
  for (std::size_t c = 0; c < copies.cells.size(); ++c) {
    for (std::size_t s = 0; s < samples; ++s, ++at) {
      if (copies.weights[at] == 0) continue;
      const std::size_t i = s * classes + class_of[c];
      const Pixel value = loaded(&copies.values[4 * at]);
      const Pixel sum = loaded(&sums[4 * i]) + value;
      std::memcpy(&sums[4 * i], &sum, sizeof sum);
      counts[i] += 1;
      squares[s] += energy(value);
    }
  }
  std::array<PlaceSums, kPlaces * kPlaces> places{};
  PlaceSums all;
  Pixel total = Pixel{};
  double count = 0, power = 0;
  for (std::size_t s = 0; s < samples; ++s) {
    Pixel sum = Pixel{};
    double n = 0, of_means = 0, seen = 0, repeated = 0;
    for (int k = 0; k < classes; ++k) {
      const std::size_t i = s * classes + k;
      if (counts[i] == 0) continue;
      const Pixel class_sum = loaded(&sums[4 * i]);
      sum += class_sum, n += counts[i], ++seen;
      of_means += energy(class_sum) / counts[i];
      repeated += counts[i] - 1;
    }
    if (n < 2) continue;
    total += sum, count += n;
    const double of_mean = energy(sum) / n;
    power += of_mean;
    const int x = static_cast<int>(s) % copies.n, y = static_cast<int>(s) / copies.n;
    PlaceSums& place = places[(y * kPlaces / copies.n) * kPlaces + x * kPlaces / copies.n];
    for (PlaceSums* to : {&place, &all}) {
      to->between += of_means - of_mean, to->between_freedom += seen - 1;
      to->within += squares[s] - of_means, to->within_freedom += repeated;
    }
  }
  SplitEvidence evidence;
  if (count == 0 || all.within_freedom < 1 || all.between_freedom < 1) return evidence;
  const double pattern = (power - energy(total) / count) / count;
  const double noise = all.within / all.within_freedom;
  evidence.within = noise;
  evidence.pairs = static_cast<int>(all.within_freedom / static_cast<double>(samples) * 100);
  const double between = all.between / all.between_freedom;
  evidence.ratio = noise > 0 ? between / noise : 0;
  // A difference of the means is seen in n copies: per copy it is that part of the energy.
  evidence.share = (all.between - noise * all.between_freedom) / count / pattern;
  const double of_place = count / (kPlaces * kPlaces);
  for (const PlaceSums& place : places) {
    if (place.between_freedom < 1) continue;
    const double own =
        std::max(noise, place.within_freedom > 0 ? place.within / place.within_freedom : 0);
    const double excess = place.between - 4 * own * place.between_freedom;
    evidence.worst = std::max(evidence.worst, excess / of_place / pattern);
  }
  return evidence;
}

bool isSplit(const SplitEvidence& evidence) {
  return (evidence.ratio > 3 && evidence.share > 0.005) || evidence.worst > 0.1;
}

}  // namespace seamwise
