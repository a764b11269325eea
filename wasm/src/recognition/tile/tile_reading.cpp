#include "recognition/tile/tile_reading.h"

#include <Eigen/LU>
#include <algorithm>
#include <numeric>
#include <string>

#include "base/sort_by.h"
#include "recognition/symmetry/stripes.h"
#include "recognition/symmetry/symmetry_tests.h"
#include "recognition/tile/tile_cell.h"
#include "tuning/group_reading.h"
#include "tuning/tile_reading.h"

namespace seamwise {
namespace {

/// A lattice that holds that of whole cells: its basis as columns, in whole shares of a cell.
struct FinerLattice {
  int shares = 1;  ///< of w1 and w2
  std::array<int, 4> basis{1, 0, 0, 1};

  Mat2 matrix() const {
    return (Mat2() << basis[0], basis[1], basis[2], basis[3]).finished() / shares;
  }
  bool isWhole() const { return std::abs(matrix().determinant()) > 1 - 1e-9; }
};

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

/// Shifts at which a correlation has a maximum of almost the whole energy, the shortest first.
std::vector<Vec2> likelyShifts(const std::vector<float>& values, int fine, double least,
                               const Mat2& gram) {
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
  sortBy(shifts, [&gram](const Vec2& shift) { return shift.dot(gram * shift); });
  return shifts;
}

bool isRepeat(const SymmetryResidual& residual) {
  return residual.rho <= GroupReadingTuning::kHasShare &&
         residual.worst <= GroupReadingTuning::kHasWorst;
}

/// Of a stripe, the smallest share of its basis vector across that lays it on itself.
FinerLattice smallerStripe(const std::array<int, 2>& along, const SymmetryTests& tests,
                           const Mat2& gram) {
  const IntegerMatrix basis = stripeBasis(along, gram);
  for (int k = TileReadingTuning::kMostStripes; k > 1; --k) {
    const Vec2 shift = Vec2(basis[0], basis[2]) / k;
    if (isRepeat(tests.residual(IntegerMatrix{1, 0, 0, 1}, shift)))
      return latticeWith(k, basis[0], basis[2]);
  }
  return {};
}

/// A smaller cell inside: the shortest shift that lays the cell on itself, and what it generates.
/// Whole cells if there is none.
/// @param missed   raised to the share of energy by which that shift misses
FinerLattice smallerCell(const CellPicture& cell, const Mat2& gram, double& missed) {
  const CellSpectrum spectrum(cell, gram);
  const SymmetryTests tests(spectrum);
  const auto along = stripeOf(spectrum);
  if (isStripe(along)) return smallerStripe(along, tests, gram);
  const IntegerMatrix identity{1, 0, 0, 1};
  const int fine = 2 * cell.n;
  const auto values = spectrum.correlation(identity);
  const double least = (1 - GroupReadingTuning::kHasNotShare) * spectrum.energy();
  int tries = 0;
  for (const Vec2& shift : likelyShifts(values, fine, least, gram)) {
    const int order = orderOfShift(shift, 1.0 / fine);
    if (order < 2) continue;
    const Vec2 exact = (order * shift).array().round().matrix() / order;
    const SymmetryResidual residual = tests.residual(identity, exact);
    if (isRepeat(residual)) {
      missed = std::max(missed, residual.raw);
      return latticeWith(order, static_cast<int>(std::lround(order * exact.x())),
                         static_cast<int>(std::lround(order * exact.y())));
    }
    if (++tries == TileReadingTuning::kMostShifts) break;
  }
  return {};
}

/// Gram matrix of a lattice on a tile whose sides have one.
Mat2 gramOn(const SeamlessTile& tile, const Mat2& sides, const LatticeMap& map) {
  const Mat2 shares = Vec2(1.0 / tile.width(), -1.0 / tile.height()).asDiagonal() *
                      map.homography.topLeftCorner<2, 2>();
  return shares.transpose() * sides * shares;
}

Mat2 squarePixels(const SeamlessTile& tile) {
  const double width = tile.width(), height = tile.height();
  return Vec2(width * width, height * height).asDiagonal();
}

/// Samples along a side: even, so that halves of the cell are samples, and no more than its pixels.
int samplesFor(const LatticeMap& map) {
  const Mat2 w = map.homography.topLeftCorner<2, 2>();
  const double pixels = std::max(w.col(0).norm(), w.col(1).norm());
  return std::clamp(2 * static_cast<int>(std::lround(pixels / 2)), TileReadingTuning::kLeastSamples,
                    TileReadingTuning::kMostSamples);
}

std::string percentOf(double share) {
  return std::to_string(static_cast<int>(std::lround(100 * share)));
}

Error openEdge(bool sides, double at) {
  const std::string which = sides ? "left and right" : "top and bottom";
  const std::string where = percentOf(at) + (sides ? " % of the way down" : " % of the way across");
  return {Failure::kPicture,
          "the picture's edges do not meet: " + which + " differ here (" + where +
              "): give the whole repeat, or a photo that shows several",
          -1, -1, "edges"};
}

Error missingLine(bool sides) {
  const std::string which = sides ? "left and right" : "top and bottom";
  const std::string line = sides ? "column" : "row";
  return {Failure::kPicture,
          "the picture's edges do not meet: " + which + " differ here, as though one " + line +
              " of pixels were cut away: give the whole repeat, or a photo that shows several",
          -1, -1, "edges"};
}

/// A reading, and the greatest share of energy by which its symmetries miss.
struct MissedTile {
  TileReading reading;
  double missed = 0;
  bool square_pixels = true;

  /// How many symmetries lie in the picture.
  int symmetries() const {
    return reading.lattice.copies * reading.groups.groups[reading.groups.best].group->order;
  }
  bool isHexagonal() const {
    const GroupReading& groups = reading.groups;
    return groups.groups[groups.best].group->lattice == LatticeType::kHexagonal;
  }
  bool isMendedBy(const MissedTile& other) const {
    if (other.reading.groups.stripes) return false;
    if (other.symmetries() != symmetries()) return other.symmetries() > symmetries();
    const bool exactly = missed > TileReadingTuning::kLeastExact &&
                         other.missed < TileReadingTuning::kExactly * missed;
    return exactly || (missed > TileReadingTuning::kLeastMissed &&
                       other.missed < TileReadingTuning::kMended * missed);
  }
};

/// The reading of a tile whose edges meet.
MissedTile readSeamless(const SeamlessTile& tile, const Mat2& sides) {
  MissedTile found;
  TileReading& reading = found.reading;
  LatticeMap& map = reading.lattice.map;
  const double width = tile.width(), height = tile.height();
  map.homography << width, 0, 0, 0, -height, height, 0, 0, 1;
  map.middle = Vec2(width, height) / 2;
  map.radius = std::max(width, height) / 2;
  for (int copies = 1;;) {
    map = map.rebased(reducingMatrix(gramOn(tile, sides, map)), Vec2::Zero());
    reading.gram = gramOn(tile, sides, map);
    reading.cell = tileCell(tile, map, samplesFor(map));
    reading.lattice.copies = copies;
    const FinerLattice smaller = smallerCell(reading.cell, reading.gram, found.missed);
    if (smaller.isWhole() || copies >= TileReadingTuning::kMostCopies) break;
    map = map.rebased(smaller.matrix(), Vec2::Zero());
    copies = static_cast<int>(std::lround(copies / smaller.matrix().determinant()));
  }
  // sides are whole numbers of pixels, whatever the lattice is
  const double rounding = TileReadingTuning::kRounding / std::min(width, height);
  reading.lattice.explained = 1;
  reading.lattice.uncertainty = rounding;
  reading.lattice.confidence = Confidence::kSure;
  reading.groups =
      readGroups(reading.cell, reading.gram, std::max(rounding, TileReadingTuning::kTolerance));
  const GroupVerdict& best = reading.groups.groups[reading.groups.best];
  found.missed = std::max(found.missed, best.raw);
  return found;
}

/// Of square pixels; or, where thirds of a turn speak for it, with the sides of a hexagonal cell.
MissedTile readWithoutSides(const SeamlessTile& tile) {
  MissedTile found = readSeamless(tile, squarePixels(tile));
  if (tile.width() != tile.height()) return found;
  for (const double cosine : {0.5, -0.5}) {
    const Mat2 hexagonal =
        (Mat2() << 1, cosine, cosine, 1).finished() * tile.width() * tile.width();
    MissedTile other = readSeamless(tile, hexagonal);
    if (!other.isHexagonal() || other.symmetries() <= found.symmetries()) continue;
    found = std::move(other);
    found.square_pixels = false;
  }
  return found;
}

/// Whether symmetries fit better on a picture that has one more column, or row.
bool isMissing(bool column, const SeamlessTile& tile, const MissedTile& found) {
  SeamlessTile more = tile;
  (column ? more.more_columns : more.more_rows) = 1;
  return found.isMendedBy(readSeamless(more, squarePixels(more)));
}

}  // namespace

Outcome<TileReading> readTile(const PixelView& tile, const TileQuestion& question) {
  if (std::min(tile.width, tile.height) < TileReadingTuning::kLeastPixels) {
    return Error{Failure::kPicture,
                 "the picture has only " + std::to_string(tile.width) + " x " +
                     std::to_string(tile.height) + " pixels: give one of at least " +
                     std::to_string(TileReadingTuning::kLeastPixels) + " each way",
                 -1, -1, "small"};
  }
  TileSeams seams;
  seams.across = leftMeetsRight(tile);
  seams.up = topMeetsBottom(tile);
  if (question.any_edges) {
    seams.half_drop = leftMeetsRight(tile, NextCopy::kHalfAside);
    seams.brick = topMeetsBottom(tile, NextCopy::kHalfAside);
  } else {
    if (!seams.across.meets) return openEdge(true, seams.across.differs_at);
    if (!seams.up.meets) return openEdge(false, seams.up.differs_at);
  }

  const auto& sides = question.sides;
  MissedTile found = sides ? readSeamless({tile}, *sides) : readWithoutSides({tile});
  // where the sides are given, a line less does not change the lattice's type
  const bool may_miss = !sides && !found.reading.groups.stripes && found.square_pixels;
  if (may_miss && seams.across.meets && seams.up.meets) {
    seams.missing_column = isMissing(true, {tile}, found);
    seams.missing_row = !seams.missing_column && isMissing(false, {tile}, found);
    if (!question.any_edges && (seams.missing_column || seams.missing_row))
      return missingLine(seams.missing_column);
  }
  found.reading.seams = std::move(seams);
  return std::move(found.reading);
}

}  // namespace seamwise
