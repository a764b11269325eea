#include "problem/reconcile.h"

#include <algorithm>
#include <cmath>

#include "base/sort_by.h"
#include "mesh/lengths.h"
#include "pattern/discretise.h"
#include "pattern/seam_measure.h"
#include "symmetry/symmetry.h"
#include "tuning/symmetry.h"

namespace seamwise {
namespace {

using Symmetries = std::vector<BodySymmetry>;

/// Degree to which a sampled pattern's symmetries contradict each other; below 1 they can all hold.
double conflict(const Pattern& pattern) {
  const auto kept = keptLengths(pattern);
  double worst = 0;
  auto side = [&](const SeamSide& s, std::vector<double>* lengths) {
    const Piece& piece = pattern.pieces[s.piece];
    double rest_sum = 0, kept_sum = 0;
    for (std::size_t i = 0; i + 1 < s.vertices.size(); ++i) {
      const int u = s.vertices[i], v = s.vertices[i + 1];
      const double rest = (piece.rest[v] - piece.rest[u]).norm();
      lengths->push_back(kept[s.piece][outlineEdge(piece, u, v)]);
      worst = std::max(worst, std::abs(lengths->back() / rest - 1) / SymmetryTuning::kEdgeChange);
      rest_sum += rest, kept_sum += lengths->back();
    }
    worst = std::max(worst, std::abs(kept_sum - rest_sum) /
                                (SymmetryTuning::kSeamChange * std::max(rest_sum, 10.0)));
  };
  for (const Seam& seam : pattern.seams) {
    std::vector<double> a, b;
    side(seam.a, &a), side(seam.b, &b);
    double missed = 0;
    for (std::size_t i = 0; i < a.size(); ++i) missed += std::abs(a[i] - seam.length_ratio * b[i]);
    worst = std::max(worst, missed / SymmetryTuning::kRatioError);
  }
  for (const Mirror& m : pattern.mirrors) {
    const auto &from = pattern.pieces[m.pieces[0]].rest, &to = pattern.pieces[m.pieces[1]].rest;
    for (std::size_t v = 0; v < m.image.size(); ++v)
      if (m.image[v] >= 0)
        worst = std::max(worst,
                         (m.map(from[v]) - to[m.image[v]]).norm() / SymmetryTuning::kImageOffset);
  }
  return worst;
}

/// The sampled pattern, if the symmetries can hold together.
std::optional<Pattern> heldTogether(const Problem& problem, const Symmetries& symmetries) {
  auto sampled = discretise(problem.garment, symmetries, symmetries, problem.options.edge_length_cm,
                            Effort::kTrial);
  if (!sampled.ok() || conflict(sampled.value()) >= 1) return {};
  return std::move(sampled).value();
}

/// Length of the seams at a symmetry's pieces that the known symmetries do not map to seams. [cm]
double unmappedSeams(const Garment& garment, const Symmetries& known, const BodySymmetry& s) {
  // The edge whose ends are the images of an edge's ends.
  auto image = [&](const EdgeRef& e) -> EdgeRef {
    for (const BodySymmetry& k : known) {
      for (int from : {0, 1}) {
        if (k.pieces[from] != e.piece || (k.single() && from == 1)) continue;
        const RigidMotion map = from == 0 ? k.map : k.map.inverse();
        const Curve& curve = garment.panels[e.piece].edges[e.edge];
        const auto& edges = garment.panels[k.pieces[1 - from]].edges;
        for (std::size_t i = 0; i < edges.size(); ++i)
          if ((map(curve.start()) - edges[i].end()).norm() < SymmetryTuning::kImageOffset &&
              (map(curve.end()) - edges[i].start()).norm() < SymmetryTuning::kImageOffset)
            return {k.pieces[1 - from], static_cast<int>(i)};
      }
    }
    return {};
  };
  double unmapped = 0;
  for (const Stitch& stitch : garment.stitches) {
    bool touches = false;
    for (int piece : s.pieces) touches |= stitch.a.piece == piece || stitch.b.piece == piece;
    if (!touches) continue;
    const EdgeRef a = image(stitch.a), b = image(stitch.b);
    const bool mapped =
        std::any_of(garment.stitches.begin(), garment.stitches.end(), [&](const Stitch& other) {
          return (other.a == a && other.b == b) || (other.a == b && other.b == a);
        });
    if (!mapped) unmapped += garment.panels[stitch.a.piece].edges[stitch.a.edge].length();
  }
  return unmapped;
}

/// The fixed symmetries plus known ones that hold together with them. Those that fit the seams best
/// are tried first.
/// @param sampled   the garment sampled with the fixed symmetries; on return with all
Symmetries consistent(const Problem& problem, const Symmetries& known, const Symmetries& fixed,
                      std::optional<Pattern>* sampled) {
  Symmetries rest;
  for (const BodySymmetry& s : known)
    if (!contains(fixed, s)) rest.push_back(s);
  sortBy(rest, [&](const BodySymmetry& symmetry) {
    return unmappedSeams(problem.garment, known, symmetry);
  });
  Symmetries kept = fixed;
  for (const BodySymmetry& s : rest) {
    kept.push_back(s);
    if (auto more = heldTogether(problem, kept))
      *sampled = std::move(more);
    else
      kept.pop_back();
  }
  return kept;
}

/// Converts a pattern sampled with the known symmetries to the mirrors of the imposed ones. Empty
/// if sampling with the imposed ones would differ.
std::optional<Pattern> asImposed(const GarmentSymmetries& symmetries,
                                 std::optional<Pattern> sampled) {
  if (!sampled || symmetries.imposed == symmetries.known) return sampled;
  if (!symmetries.imposed.empty()) return {};
  sampled->mirrors.clear();
  setLengthRatios(*sampled);
  return sampled;
}

}  // namespace

bool contains(const std::vector<BodySymmetry>& list, const BodySymmetry& s) {
  return std::any_of(list.begin(), list.end(), [&](const BodySymmetry& other) {
    return other.pieces[0] == s.pieces[0] && other.pieces[1] == s.pieces[1];
  });
}

std::string called(const Garment& garment, const BodySymmetry& s) {
  return (s.single() ? "piece " : "the pair ") + namesOf(garment, s);
}

Outcome<Reconciled> reconcile(const Problem& problem, const GarmentSymmetries& symmetries) {
  Reconciled left{symmetries, {}, heldTogether(problem, symmetries.known)};
  if (!left.sampled) {
    const Symmetries fixed = symmetries.optional ? Symmetries{} : symmetries.imposed;
    if (!fixed.empty() && !(left.sampled = heldTogether(problem, fixed))) {
      std::string names;
      for (const BodySymmetry& s : fixed)
        names += (names.empty() ? "" : ", ") + called(problem.garment, s);
      return Error{Failure::kSymmetryConflict,
                   "The symmetries of " + names +
                       " cannot all hold: mirrored edges are sewn to edges that do not mirror. "
                       "Leave one of them out.",
                   fixed.front().pieces[0], -1, "symmetrySewn"};
    }
    const Symmetries& kept = left.symmetries.known =
        consistent(problem, symmetries.known, fixed, &left.sampled);
    left.symmetries.imposed.clear();
    for (const BodySymmetry& s : symmetries.imposed) {
      if (contains(kept, s))
        left.symmetries.imposed.push_back(s);
      else
        left.notes.push_back({"symmetrySewn",
                              "The symmetry of " + called(problem.garment, s) +
                                  " is dropped: its mirrored edges are sewn to edges that do not "
                                  "mirror.",
                              piecesOf(s)});
    }
  }
  left.sampled = asImposed(left.symmetries, std::move(left.sampled));
  return left;
}

}  // namespace seamwise
