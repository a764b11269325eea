#include "photo/lattice/primitive_cell.h"

#include <Eigen/LU>
#include <limits>
#include <optional>

#include "photo/lattice/cell_tests.h"
#include "photo/lattice/lattice_fit.h"
#include "wallpaper/lattice.h"

namespace seamwise {
namespace {

constexpr double kComparedCells = 5;     // cells from the middle whose copies are compared
constexpr int kCoarse = 16, kFine = 24;  // samples along a cell
constexpr double kMostLost = 0.15;       // accepted loss of the explained share; the tests decide
constexpr double kShortestSide = 6;      // minimum length of a repeat. [pixels of the first level]
constexpr double kFlattest = 0.15;       // minimum of shorter over longer side of a cell
constexpr double kClearlyLess = 0.8;     // ratio of differences for a still larger cell; chosen
constexpr int kMostRounds = 4;
constexpr int kLargestIndex = 6;

Copies copiesOf(const std::vector<ChannelImage>& levels, const TiltedLattice& view, int n) {
  return sampleCopies(levelFor(levels, view, n), view, visibleCells(view, kComparedCells), n,
                      false);
}

/// Returns the same lattice in its shortest basis; stripes stay unchanged.
CellChoice withShortBasis(CellChoice choice) {
  if (choice.is_stripes) return choice;
  const auto reduced = lagrangeReduced(choice.view.basis.col(0), choice.view.basis.col(1));
  choice.view.basis.col(0) = reduced[0];
  choice.view.basis.col(1) = reduced[1];
  return choice;
}

bool isCell(const ChannelImage& image, const CellChoice& choice) {
  const Vec2 first = choice.view.basis.col(0), second = choice.view.basis.col(1);
  if (first.norm() * choice.view.radius * image.scale < kShortestSide) return false;
  return choice.is_stripes || first.norm() > kFlattest * second.norm();
}

std::optional<CellChoice> smaller(const std::vector<ChannelImage>& levels, const CellChoice& choice,
                                  double explained) {
  for (const int index : {2, 3, 5}) {
    for (const Mat2& m : largerCells(index)) {
      if (choice.is_stripes && m(1, 1) != 1) continue;
      // The transpose gives lattices that contain this one, instead of its sublattices.
      const CellChoice finer =
          withShortBasis({choice.view.rebased(m.transpose().inverse()), choice.is_stripes});
      if (!isCell(levels[0], finer)) continue;
      const Copies copies = copiesOf(levels, finer.view, kCoarse);
      if (agreementOf(copies).explained < explained - kMostLost) continue;
      // The previous lattice, in the smaller one's basis.
      const Mat2 larger = (finer.view.basis.inverse() * choice.view.basis).array().rint().matrix();
      if (!isSplit(
              splitEvidence(CopyDifferences(copies), Mat2::Identity(), larger, finer.view.basis)))
        return finer;
    }
  }
  return std::nullopt;
}

}  // namespace

CellChoice withSmallestCell(const std::vector<ChannelImage>& levels, CellChoice choice) {
  choice = withShortBasis(choice);
  const double explained = agreementOf(copiesOf(levels, choice.view, kCoarse)).explained;
  for (int round = 0; round < kMostRounds; ++round) {
    const auto finer = smaller(levels, choice, explained);
    if (!finer) break;
    choice = *finer;
  }
  return choice;
}

CellChoice withLargerCell(const std::vector<ChannelImage>& levels, CellChoice choice) {
  const CopyDifferences differences(copiesOf(levels, choice.view, kFine));
  Mat2 lattice = Mat2::Identity();
  for (int round = 0; round < kMostRounds; ++round) {
    Mat2 best = Mat2::Identity();
    double least = std::numeric_limits<double>::max();
    for (int index = 2; index <= kLargestIndex; ++index) {
      for (const Mat2& m : largerCells(index)) {
        if (choice.is_stripes && m(1, 1) != 1) continue;
        const SplitEvidence evidence = splitEvidence(differences, lattice, m, choice.view.basis);
        if (!isSplit(evidence) || evidence.within > kClearlyLess * least) continue;
        least = evidence.within;
        best = m;
      }
    }
    if (best == Mat2::Identity()) break;
    lattice = lattice * best;
  }
  choice.view = choice.view.rebased(lattice);
  return withShortBasis(choice);
}

}  // namespace seamwise
