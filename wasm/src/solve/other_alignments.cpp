#include "solve/other_alignments.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/sort_by.h"
#include "methods/predicted_mismatch.h"
#include "methods/seam_rules.h"

namespace seamwise {
namespace {

/// A viewer does not notice a smaller shift of the print on a piece. [cm]
constexpr double kSamePrint = 0.5;
/// Tolerances of the mismatch expected after shaping, compared with the best: a share plus a length
/// in cm. They are twice the difference that counts as equal after shaping, because the expectation
/// is a guess.
constexpr double kAsGood = 0.2, kAsGoodCm = 0.02;

/// Greatest shift of the print on a piece between two alignments, under the rotation of the print
/// that minimizes it. [cm]
double printApart(const WallpaperGroup& group, const Piece& piece, const Alignment& one,
                  const Alignment& other) {
  double least = std::numeric_limits<double>::infinity();
  for (const Element& element : group.elements()) {
    if (element.mirrored) continue;
    double greatest = 0;
    for (const int v : piece.outline) {
      const Vec2 &p = piece.rest[v], there = element(other.toPrint(p));
      greatest = std::max(greatest, group.reduce(one.toPrint(p) - there).norm());
      if (greatest >= least) break;
    }
    least = std::min(least, greatest);
  }
  return least;
}

bool isSame(const WallpaperGroup& group, const Pattern& pattern, const Alignments& one,
            const Alignments& other) {
  for (std::size_t p = 0; p < pattern.pieces.size(); ++p)
    if (printApart(group, pattern.pieces[p], one[p], other[p]) >= kSamePrint) return false;
  return true;
}

}  // namespace

std::vector<OtherAlignment> otherAlignments(const WallpaperGroup& group, const Pattern& pattern,
                                            const Shapes& rest, const std::vector<Alignments>& at,
                                            const std::vector<Alignments>& found, double reach) {
  const std::vector<double> lengths = seamLengths(pattern, rest);
  const auto expected = [&](const Alignments& pieces) {
    return meanMismatch(predictedMismatches(group, pattern, pieces, reach), lengths);
  };
  double best = std::numeric_limits<double>::infinity();
  for (const Alignments& pieces : at) best = std::min(best, expected(pieces));
  std::vector<OtherAlignment> others;
  others.reserve(found.size());
  for (const Alignments& pieces : found)
    others.push_back({pieces, meanMismatch(localMismatches(group, pattern, rest, pieces), lengths),
                      expected(pieces)});
  sortBy(others, [](const OtherAlignment& other) { return other.expected; });
  std::vector<OtherAlignment> kept;
  for (OtherAlignment& other : others) {
    if (other.expected > best * (1 + kAsGood) + kAsGoodCm) break;
    const auto same = [&](const Alignments& pieces) {
      return isSame(group, pattern, pieces, other.pieces);
    };
    const auto sameKept = [&](const OtherAlignment& one) { return same(one.pieces); };
    if (std::none_of(at.begin(), at.end(), same) &&
        std::none_of(kept.begin(), kept.end(), sameKept))
      kept.push_back(std::move(other));
  }
  return kept;
}

}  // namespace seamwise
