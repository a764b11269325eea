#include "solve/prepare.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "deform/lengths.h"
#include "deform/mesh.h"
#include "pattern/discretise.h"

namespace seamwise {
namespace {

using Symmetries = std::vector<BodySymmetry>;

constexpr double kCoarsest = 6.0;  ///< cm: greatest triangles inside; the interior is smooth

// What symmetries may ask of the drafted outlines, well inside what a finished shape may change.
constexpr double kRatioError = 4e-3;  ///< cm by which the sides of a whole seam miss their ratio
constexpr double kEdgeChange = 0.08;  ///< of a sewn edge's rest length
constexpr double kSeamChange = 0.01;  ///< of a seam side's rest length, or as many times 10 cm
constexpr double kImageOffset = 0.3;  ///< cm between a vertex and its image

/// How badly a sampled pattern's symmetries contradict each other: below 1 they can all hold.
double conflict(const Pattern& pattern) {
  const auto kept = keptLengths(pattern);
  double worst = 0;
  auto side = [&](const SeamSide& s, std::vector<double>* lengths) {
    const Piece& piece = pattern.pieces[s.piece];
    const int n = static_cast<int>(piece.outline.size());
    double rest_sum = 0, kept_sum = 0;
    for (std::size_t i = 0; i + 1 < s.vertices.size(); ++i) {
      const int u = s.vertices[i], v = s.vertices[i + 1];
      const double rest = (piece.rest[v] - piece.rest[u]).norm();
      lengths->push_back(kept[s.piece][(u + 1) % n == v ? u : v]);
      worst = std::max(worst, std::abs(lengths->back() / rest - 1) / kEdgeChange);
      rest_sum += rest, kept_sum += lengths->back();
    }
    worst = std::max(worst, std::abs(kept_sum - rest_sum) / (kSeamChange * std::max(rest_sum, 10.0)));
  };
  for (const Seam& seam : pattern.seams) {
    std::vector<double> a, b;
    side(seam.a, &a), side(seam.b, &b);
    double missed = 0;
    for (std::size_t i = 0; i < a.size(); ++i) missed += std::abs(a[i] - seam.length_ratio * b[i]);
    worst = std::max(worst, missed / kRatioError);
  }
  for (const Mirror& m : pattern.mirrors) {
    const auto &from = pattern.pieces[m.pieces[0]].rest, &to = pattern.pieces[m.pieces[1]].rest;
    for (std::size_t v = 0; v < m.image.size(); ++v)
      if (m.image[v] >= 0)
        worst = std::max(worst, (m.map(from[v]) - to[m.image[v]]).norm() / kImageOffset);
  }
  return worst;
}

/// conflict(), or infinity when the outlines cannot even be sampled so.
double conflictOf(const Problem& problem, const Symmetries& symmetries) {
  const auto sampled =
      discretise(problem.garment, symmetries, symmetries, problem.options.edge_length_cm);
  return sampled.ok() ? conflict(sampled.value()) : std::numeric_limits<double>::infinity();
}

bool contains(const Symmetries& list, const BodySymmetry& s) {
  return std::any_of(list.begin(), list.end(), [&](const BodySymmetry& other) {
    return other.pieces[0] == s.pieces[0] && other.pieces[1] == s.pieces[1];
  });
}

Symmetries without(Symmetries list, const BodySymmetry& s) {
  list.erase(std::remove_if(list.begin(), list.end(),
                            [&](const BodySymmetry& other) {
                              return other.pieces[0] == s.pieces[0] &&
                                     other.pieces[1] == s.pieces[1];
                            }),
             list.end());
  return list;
}

std::string namesOf(const Garment& garment, const BodySymmetry& s) {
  const std::string first = "'" + garment.panels[s.pieces[0]].name + "'";
  return s.single() ? "piece " + first
                    : "the pair " + first + " and '" + garment.panels[s.pieces[1]].name + "'";
}

}  // namespace

Outcome<Pattern> preparedPattern(Problem& problem) {
  Symmetries& known = problem.known;
  double worst = conflictOf(problem, known);
  while (worst >= 1 && !known.empty()) {
    // leave out the one without which the rest contradict each other least
    const BodySymmetry* dropped = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const BodySymmetry& s : known) {
      if (!problem.symmetries_optional && contains(problem.imposed, s)) continue;
      const double rest = conflictOf(problem, without(known, s));
      if (!dropped || rest < least) dropped = &s, least = rest;
    }
    if (!dropped) {
      std::string names;
      for (const BodySymmetry& s : problem.imposed)
        names += (names.empty() ? "" : ", ") + namesOf(problem.garment, s);
      return Error{Failure::kSymmetryConflict,
                   "The symmetries of " + names +
                       " cannot all hold: mirrored edges are sewn to edges that do not mirror. "
                       "Leave one of them out.",
                   problem.imposed.empty() ? -1 : problem.imposed.front().pieces[0]};
    }
    const BodySymmetry gone = *dropped;
    if (contains(problem.imposed, gone))
      problem.notes.push_back("The symmetry of " + namesOf(problem.garment, gone) +
                              " is dropped: its mirrored edges are sewn to edges that do not mirror.");
    problem.imposed = without(problem.imposed, gone);
    known = without(known, gone);
    worst = least;
  }
  Outcome<Pattern> sampled =
      discretise(problem.garment, known, problem.imposed, problem.options.edge_length_cm);
  if (!sampled.ok()) return sampled.error();
  return meshed(std::move(sampled).value(), kCoarsest);
}

}  // namespace seamwise
