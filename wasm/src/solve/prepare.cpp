#include "solve/prepare.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

#include "deform/lengths.h"
#include "deform/mesh.h"
#include "pattern/discretise.h"
#include "solve/placing_rules.h"
#include "solve/promise.h"
#include "symmetry/symmetry.h"

namespace seamwise {
namespace {

using Symmetries = std::vector<BodySymmetry>;

constexpr double kCoarsest = 6.0;  ///< cm: greatest triangles inside; the interior is smooth

// What symmetries may ask of the drafted outlines, well inside what a finished shape may change.
constexpr double kRatioError = 4e-3;  ///< cm by which the sides of a whole seam miss their ratio
constexpr double kEdgeChange = 0.08;  ///< of a sewn edge's rest length
constexpr double kSeamChange = 0.01;  ///< of a seam side's rest length, or as many times 10 cm
constexpr double kImageOffset = 0.3;  ///< cm between a vertex and its image

// What evening out may take of what a finished shape may change; the rest is left to the fit.
constexpr double kEvenedShare = 0.98;    ///< of the greatest change
constexpr double kEvenedAlready = 5e-7;  ///< cm that are no movement at all
constexpr double kEvenedKink = 12 * kPi / 180;
constexpr double kEvenedStretch = 0.12;
constexpr double kEvenedArea = 0.5;
constexpr double kEvenedSeam = 0.9 * kSeamTolerance;
constexpr double kFinest = 0.3;  ///< of the edge length asked for
constexpr double kRoom = 0.1;    ///< cm of movement that are enough for lengths to settle

/// How badly a sampled pattern's symmetries contradict each other: below 1 they can all hold.
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
      worst = std::max(worst, std::abs(lengths->back() / rest - 1) / kEdgeChange);
      rest_sum += rest, kept_sum += lengths->back();
    }
    worst =
        std::max(worst, std::abs(kept_sum - rest_sum) / (kSeamChange * std::max(rest_sum, 10.0)));
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
  const auto sampled = discretise(problem.garment, symmetries, symmetries,
                                  problem.options.edge_length_cm, Effort::kTrial);
  return sampled.ok() ? conflict(sampled.value()) : std::numeric_limits<double>::infinity();
}

bool contains(const Symmetries& list, const BodySymmetry& s) {
  return std::any_of(list.begin(), list.end(), [&](const BodySymmetry& other) {
    return other.pieces[0] == s.pieces[0] && other.pieces[1] == s.pieces[1];
  });
}

/// Length of the seams at a symmetry's pieces that the known symmetries do not map to seams. [cm]
double unmappedSeams(const Garment& garment, const Symmetries& known, const BodySymmetry& s) {
  // the edge onto which an edge falls, by its ends
  auto image = [&](const EdgeRef& e) -> EdgeRef {
    for (const BodySymmetry& k : known) {
      for (int from : {0, 1}) {
        if (k.pieces[from] != e.piece || (k.single() && from == 1)) continue;
        const RigidMotion map = from == 0 ? k.map : k.map.inverse();
        const Curve& curve = garment.panels[e.piece].edges[e.edge];
        const auto& edges = garment.panels[k.pieces[1 - from]].edges;
        for (std::size_t i = 0; i < edges.size(); ++i)
          if ((map(curve.start()) - edges[i].end()).norm() < kImageOffset &&
              (map(curve.end()) - edges[i].start()).norm() < kImageOffset)
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

/// As many of the known symmetries as hold together: the fixed ones, then those first that fit the
/// seams best.
Symmetries consistent(const Problem& problem, const Symmetries& fixed) {
  Symmetries rest;
  for (const BodySymmetry& s : problem.known)
    if (!contains(fixed, s)) rest.push_back(s);
  std::stable_sort(rest.begin(), rest.end(), [&](const BodySymmetry& a, const BodySymmetry& b) {
    return unmappedSeams(problem.garment, problem.known, a) <
           unmappedSeams(problem.garment, problem.known, b);
  });
  Symmetries kept = fixed;
  for (const BodySymmetry& s : rest) {
    kept.push_back(s);
    if (conflictOf(problem, kept) >= 1) kept.pop_back();
  }
  return kept;
}

std::string called(const Garment& garment, const BodySymmetry& s) {
  return (s.single() ? "piece " : "the pair ") + namesOf(garment, s);
}

std::string shown(double value, const char* format) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// Why a symmetry cannot hold, as "<symmetry>: <why>", and what to do about it.
struct Obstacle {
  std::size_t symmetry = 0;  ///< index among the imposed ones
  std::string why, remedy;
};

/// Whether edges of a seam miss their ratio on pieces that may not move enough to restore it: one
/// side bends more than the other, or several seams and symmetries share its vertices out. The
/// error shrinks with the edges.
bool isStiff(const Pattern& pattern, const Shapes& evened, double max_change) {
  return max_change < kRoom &&
         std::any_of(pattern.seams.begin(), pattern.seams.end(),
                     [&](const Seam& seam) { return seamError(seam, evened) > kEvenedSeam; });
}

/// Shapes start from the evened pattern, and fall back to it: it must keep every promise by itself.
std::optional<Obstacle> obstacle(const Pattern& pattern, std::size_t symmetry, const Shapes& evened,
                                 double max_change) {
  const Mirror& m = pattern.mirrors[symmetry];
  for (const int p : m.pieces) {
    const Piece& piece = pattern.pieces[p];
    const double moved = movedOf(piece, evened[p]);
    if (moved > std::max(kEvenedShare * max_change, kEvenedAlready))
      return Obstacle{symmetry,
                      "its outlines would have to move by " + shown(moved, "%.2g") +
                          " cm to mirror each other exactly, which maxChangeCm does not allow",
                      "raise maxChangeCm to " + shown(1.1 * moved, "%.2g")};
    Limits limits;
    limits.moved = moved, limits.kink = kEvenedKink;
    limits.stretch = kEvenedStretch, limits.area = kEvenedArea;
    if (breachOf(piece, evened[p], limits) != Breach::kNone)
      return Obstacle{symmetry,
                      "its outlines differ so much from edge to edge that they would get kinks or "
                      "folds if they were made to mirror each other exactly",
                      "choose longer edges (edgeLengthCm), or draw them alike"};
  }
  for (const Seam& seam : pattern.seams) {
    double moved = 0;
    for (const int p : {seam.a.piece, seam.b.piece})
      if (p == m.pieces[0] || p == m.pieces[1])
        moved = std::max(moved, movedOf(pattern.pieces[p], evened[p]));
    if (moved > kEvenedAlready && max_change - moved < kRoom &&
        seamError(seam, evened) > kEvenedSeam)
      return Obstacle{symmetry,
                      "where its outlines are made to mirror each other exactly, seams lose their "
                      "length ratio, and maxChangeCm leaves no room to restore it",
                      "raise maxChangeCm to " + shown(moved + kRoom, "%.2g")};
  }
  return {};
}

/// Drops detected symmetries that contradict each other, with a note. Errors: kSymmetryConflict
/// when those asked for do.
std::optional<Error> reconcile(Problem& problem) {
  if (conflictOf(problem, problem.known) < 1) return {};
  const Symmetries fixed = problem.symmetries_optional ? Symmetries{} : problem.imposed;
  if (!fixed.empty() && conflictOf(problem, fixed) >= 1) {
    std::string names;
    for (const BodySymmetry& s : fixed)
      names += (names.empty() ? "" : ", ") + called(problem.garment, s);
    return Error{Failure::kSymmetryConflict,
                 "The symmetries of " + names +
                     " cannot all hold: mirrored edges are sewn to edges that do not mirror. "
                     "Leave one of them out.",
                 fixed.front().pieces[0]};
  }
  const Symmetries kept = consistent(problem, fixed);
  Symmetries imposed;
  for (const BodySymmetry& s : problem.imposed) {
    if (contains(kept, s))
      imposed.push_back(s);
    else
      problem.notes.push_back("The symmetry of " + called(problem.garment, s) +
                              " is dropped: its mirrored edges are sewn to edges that do not "
                              "mirror.");
  }
  problem.imposed = std::move(imposed);
  problem.known = kept;
  return {};
}

Outcome<Pattern> sampledAndMeshed(const Problem& problem, double edge_length) {
  Outcome<Pattern> sampled =
      discretise(problem.garment, problem.known, problem.imposed, edge_length);
  if (!sampled.ok()) return sampled.error();
  return meshed(std::move(sampled).value(), kCoarsest);
}

/// Drops a found symmetry, with a note. Error when it was asked for, with advice that ends the
/// sentence.
std::optional<Error> dropOrRefuse(Problem& problem, std::size_t index, Failure code,
                                  const std::string& why, const std::string& advice) {
  const BodySymmetry& symmetry = problem.imposed[index];
  const std::string name = called(problem.garment, symmetry);
  if (!problem.symmetries_optional)
    return Error{code,
                 "The symmetry of " + name + " cannot hold: " + why + advice +
                     ", or leave out that symmetry.",
                 symmetry.pieces[0]};
  problem.notes.push_back("The symmetry of " + name + " is dropped: " + why + ".");
  problem.imposed.erase(problem.imposed.begin() + static_cast<std::ptrdiff_t>(index));
  return {};
}

/// No symmetry is left that pins or grain contradict. Errors: kSymmetryConflict when it was asked
/// for.
std::optional<Error> heedRules(Problem& problem) {
  const struct {
    std::optional<std::size_t> (*against)(const Problem&);
    const char *why, *advice;
  } rules[] = {
      {symmetryAgainstPins, "as it is pinned, the print does not mirror so", ". Move the pin"},
      {symmetryAgainstGrain, "on this print it would take the piece off its grain",
       ". Turn the print, free the grain"}};
  for (const auto& rule : rules)
    while (const auto against = rule.against(problem))
      if (auto error =
              dropOrRefuse(problem, *against, Failure::kSymmetryConflict, rule.why, rule.advice))
        return error;
  return {};
}

}  // namespace

Outcome<Pattern> preparedPattern(Problem& problem) {
  if (const auto error = heedRules(problem)) return *error;
  if (const auto error = reconcile(problem)) return *error;
  const double max_change = problem.options.max_change_cm;
  double edge_length = problem.options.edge_length_cm;
  for (;;) {
    Outcome<Pattern> ready = sampledAndMeshed(problem, edge_length);
    std::optional<Obstacle> found;
    if (ready.ok()) {
      const Pattern& pattern = ready.value();
      const Shapes evened = evenedShapes(pattern);
      for (std::size_t m = 0; m < pattern.mirrors.size() && !found; ++m)
        found = obstacle(pattern, m, evened, max_change);
      const bool finer = !found && edge_length > kFinest * problem.options.edge_length_cm &&
                         isStiff(pattern, evened, max_change);
      if (finer) {
        edge_length /= 2;
        continue;
      }
      if (!found) return ready;
    } else {
      // what cannot be meshed as its own mirror image may do without it
      for (std::size_t m = 0; m < problem.imposed.size() && !found; ++m)
        if (problem.imposed[m].pieces[0] == ready.error().piece)
          found =
              Obstacle{m, "its outline would cross itself if it were made to mirror exactly", ""};
      if (!found || !problem.symmetries_optional) return ready.error();
    }
    if (const auto error = dropOrRefuse(problem, found->symmetry, Failure::kSymmetryDoesNotMirror,
                                        found->why, "; " + found->remedy))
      return *error;
  }
}

}  // namespace seamwise
