#include "photo/lattice/cell_tests.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "wallpaper/lattice.h"

namespace seamwise {
namespace {

using Pixel = ChannelImage::Pixel;

constexpr double kLeastSeen = 0.3;  // minimum share of a cell that pairs must show; chosen

float energy(const Pixel& pixel) {
  return pixel[0] * pixel[0] + pixel[1] * pixel[1] + pixel[2] * pixel[2];
}

}  // namespace

std::vector<Mat2> largerCells(int index) {
  std::vector<Mat2> cells;
  for (int a = 1; a <= index; ++a) {
    if (index % a != 0) continue;
    const int d = index / a;
    for (int b = 0; b < a; ++b) cells.push_back((Mat2() << a, b, 0, d).finished());
  }
  return cells;
}

CopyDifferences::CopyDifferences(const Copies& copies)
    : shifts_(static_cast<std::size_t>(2 * kReach + 1) * (kReach + 1)) {
  const int n = copies.n;
  const std::size_t samples = copies.samples();
  std::vector<int> place_of(samples);
  for (std::size_t s = 0; s < samples; ++s) {
    const int x = static_cast<int>(s) % n, y = static_cast<int>(s) / n;
    place_of[s] = (y * kPlaces / n) * kPlaces + x * kPlaces / n;
  }
  constexpr int kColumns = 2 * kReach + 1;
  std::vector<std::array<float, kPlaces * kPlaces>> counts(shifts_.size());
  for (auto& count : counts) count.fill(0);
  for (std::size_t a = 0; a < copies.cells.size(); ++a) {
    for (std::size_t b = 0; b < copies.cells.size(); ++b) {
      const int i = copies.cells[b][0] - copies.cells[a][0];
      const int j = copies.cells[b][1] - copies.cells[a][1];
      if (j < 0 || (j == 0 && i <= 0) || j > kReach || std::abs(i) > kReach) continue;
      const std::size_t shift = j * kColumns + i + kReach;
      for (std::size_t s = 0; s < samples; ++s) {
        const std::size_t first = a * samples + s, second = b * samples + s;
        if (copies.weights[first] == 0 || copies.weights[second] == 0) continue;
        shifts_[shift].places[place_of[s]] +=
            energy(loaded(&copies.values[4 * first]) - loaded(&copies.values[4 * second]));
        counts[shift][place_of[s]] += 1;
      }
    }
  }
  for (std::size_t shift = 0; shift < shifts_.size(); ++shift) {
    Difference& difference = shifts_[shift];
    int seen = 0;
    for (std::size_t p = 0; p < difference.places.size(); ++p) {
      const float count = counts[shift][p];
      difference.places[p] = count > 0 ? difference.places[p] / count : -1;
      if (count == 0) continue;
      difference.mean += difference.places[p], ++seen;
    }
    difference.mean /= std::max(1, seen);
    difference.share = static_cast<double>(seen) / (kPlaces * kPlaces);
  }
  const CopiesMean mean = meanOf(copies);
  Pixel sum = Pixel{};
  double squares = 0, count = 0;
  for (std::size_t s = 0; s < samples; ++s) {
    if (mean.weights[s] == 0) continue;
    const Pixel value = loaded(&mean.values[4 * s]);
    sum += value, squares += energy(value), ++count;
  }
  if (count > 0) pattern_ = (squares - energy(sum) / count) / count;
}

const CopyDifferences::Difference* CopyDifferences::at(int i, int j) const {
  if (j < 0 || (j == 0 && i < 0)) i = -i, j = -j;
  if (j > kReach || std::abs(i) > kReach) return nullptr;
  const Difference& difference = shifts_[j * (2 * kReach + 1) + i + kReach];
  return difference.share >= kLeastSeen ? &difference : nullptr;
}

SplitEvidence splitEvidence(const CopyDifferences& differences, const Mat2& lattice,
                            const Mat2& larger, const Mat2& basis) {
  const auto whole = [](const Mat2& m, const Vec2& v) { return Vec2((m * v).array().rint()); };
  const auto at = [&](const Vec2& shift) {
    return differences.at(static_cast<int>(std::lround(shift.x())),
                          static_cast<int>(std::lround(shift.y())));
  };
  // Copies that coincide in the larger cell, by its two shortest vectors.
  const Mat2 own = lattice * larger;
  const Mat2 seen = basis * own;
  const auto reduced = lagrangeReduced(seen.col(0), seen.col(1));
  const Mat2 back = basis.inverse();
  const auto* first = at(whole(back, reduced[0]));
  const auto* second = at(whole(back, reduced[1]));
  SplitEvidence evidence;
  if (first == nullptr || second == nullptr) return evidence;
  evidence.within = std::max(first->mean, second->mean);
  // Other copies, by the shortest shift of each class that is no longer than the longer of the two.
  const int index = static_cast<int>(std::lround(std::abs(larger.determinant())));
  const Mat2 own_inverse = own.inverse();
  struct Shortest {
    double key, length;
    const CopyDifferences::Difference* difference;
  };
  std::vector<Shortest> shortest;  // one per class
  for (int j = -CopyDifferences::kReach; j <= CopyDifferences::kReach; ++j) {
    for (int i = -CopyDifferences::kReach; i <= CopyDifferences::kReach; ++i) {
      const Vec2 shift = lattice * Vec2(i, j);
      const auto* difference = at(shift);
      if (difference == nullptr) continue;
      const double length = (basis * shift).norm();
      if (length > reduced[1].norm() * 1.001) continue;
      Vec2 rest = own_inverse * shift;
      rest -= Vec2((rest.array() + 1e-6).floor());
      const double key = std::lround(rest.x() * 5040) * 10000.0 + std::lround(rest.y() * 5040);
      if (key == 0) continue;
      std::size_t k = 0;
      while (k < shortest.size() && shortest[k].key != key) ++k;
      if (k == shortest.size()) {
        shortest.push_back({key, length, difference});
      } else if (length < shortest[k].length) {
        shortest[k] = {key, length, difference};
      }
    }
  }
  if (static_cast<int>(shortest.size()) < index - 1) return evidence;
  double between = 0;
  std::array<double, CopyDifferences::kPlaces * CopyDifferences::kPlaces> places{};
  std::array<int, CopyDifferences::kPlaces * CopyDifferences::kPlaces> counts{};
  for (const auto& [key, length, difference] : shortest) {
    between += difference->mean / static_cast<double>(shortest.size());
    for (std::size_t p = 0; p < places.size(); ++p)
      if (difference->places[p] >= 0) places[p] += difference->places[p], ++counts[p];
  }
  evidence.ratio = evidence.within > 0 ? between / evidence.within : 0;
  evidence.share = (between - evidence.within) / (2 * differences.pattern());
  for (std::size_t p = 0; p < places.size(); ++p) {
    if (counts[p] == 0 || first->places[p] < 0 || second->places[p] < 0) continue;
    const double here = std::max({static_cast<double>(first->places[p]),
                                  static_cast<double>(second->places[p]), evidence.within});
    const double excess = places[p] / counts[p] - 2 * here;
    evidence.worst = std::max(evidence.worst, excess / (2 * differences.pattern()));
  }
  return evidence;
}

bool isSplit(const SplitEvidence& evidence) {
  return (evidence.ratio > 2 && evidence.share > 0.01) ||
         (evidence.ratio > 1.1 && evidence.worst > 0.3);
}

}  // namespace seamwise
