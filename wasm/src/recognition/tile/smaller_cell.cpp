#include "recognition/tile/smaller_cell.h"

#include <Eigen/LU>
#include <numeric>

#include "base/sort_by.h"
#include "recognition/symmetry/stripes.h"
#include "tuning/group_reading.h"
#include "tuning/tile_reading.h"

namespace seamwise {
namespace {

/// The lattice that whole cells and a k-th of the vector (a, b) generate.
FinerLattice latticeWith(int k, int a, int b) {
  // columns (k, 0), (a, b) by Euclid to (g, y), (0, z)
  std::array<int, 2> one{k, 0}, two{a, b};
  while (two[0] != 0) {
    const int times = one[0] / two[0];
    one = {one[0] - times * two[0], one[1] - times * two[1]};
    std::swap(one, two);
  }
  if (one[0] < 0) one = {-one[0], -one[1]};
  const int z = std::gcd(two[1], k);
  return {k, {one[0], 0, ((one[1] % z) + z) % z, z}};
}

/// The smallest k for which k times a vector is whole, to within what is read of a correlation.
int orderOfShift(const Vec2& shift, double error) {
  constexpr int kMost = 64;
  for (int k = 1; k <= kMost; ++k) {
    const Vec2 multiple = k * shift;
    const Vec2 off = multiple - multiple.array().round().matrix();
    if (off.cwiseAbs().maxCoeff() <= k * error) return k;
  }
  return 0;
}

/// Shifts at which a correlation has a maximum of almost the whole energy.
std::vector<Vec2> likelyShifts(const std::vector<float>& values, int fine, double least) {
  std::vector<Vec2> shifts;
  for (int j = 0; j < fine; ++j) {
    for (int i = 0; i < fine; ++i) {
      const float value = values[j * fine + i];
      if ((i == 0 && j == 0) || value < least) continue;
      bool greatest = true;
      for (int dj = -1; dj <= 1; ++dj) {
        for (int di = -1; di <= 1; ++di) {
          greatest &= value >= values[(j + dj + fine) % fine * fine + (i + di + fine) % fine];
        }
      }
      const Vec2 shift(i > fine / 2 ? i - fine : i, j > fine / 2 ? j - fine : j);
      if (greatest) shifts.push_back(shift / fine);
    }
  }
  return shifts;
}

}  // namespace

SmallerCellSearch::SmallerCellSearch(const CellPicture& cell, const Mat2& gram)
    : spectrum_(cell, gram), tests_(spectrum_) {
  const auto along = stripeOf(spectrum_);
  if (isStripe(along))
    addStripes(along, gram);
  else
    addLikely(gram);
}

void SmallerCellSearch::addStripes(const std::array<int, 2>& along, const Mat2& gram) {
  const IntegerMatrix basis = stripeBasis(along, gram);
  for (int k = TileReadingTuning::kMostStripes; k > 1; --k)
    shifts_[count_++] = {k, basis[0], basis[2]};
}

/// The shortest first.
void SmallerCellSearch::addLikely(const Mat2& gram) {
  const int fine = 2 * spectrum_.n();
  const double least = (1 - GroupReadingTuning::kHasNotShare) * spectrum_.energy();
  const std::vector<Vec2> shifts = likelyShifts(spectrum_.correlation({1, 0, 0, 1}), fine, least);
  std::vector<double> squares;
  squares.reserve(shifts.size());
  for (const Vec2& shift : shifts) squares.push_back(shift.dot(gram * shift));
  for (const std::size_t place : placesInOrder(squares)) {
    if (count_ == TileReadingTuning::kMostShifts) break;
    const Vec2& shift = shifts[place];
    const int order = orderOfShift(shift, 1.0 / fine);
    if (order < 2) continue;
    shifts_[count_++] = {order, static_cast<int>(std::lround(order * shift.x())),
                         static_cast<int>(std::lround(order * shift.y()))};
  }
}

bool SmallerCellSearch::advance() {
  if (tested_ == count_) return false;
  const auto [order, a, b] = shifts_[tested_++];
  const SymmetryResidual residual = tests_.residual(IntegerMatrix{1, 0, 0, 1}, Vec2(a, b) / order);
  const bool is_repeat = residual.rho <= GroupReadingTuning::kHasShare &&
                         residual.worst <= GroupReadingTuning::kHasWorst;
  if (!is_repeat) return true;
  missed_ = residual.raw;
  lattice_ = latticeWith(order, a, b);
  tested_ = count_;
  return false;
}

}  // namespace seamwise
