#include "solve/prepare.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

#include "deform/lengths.h"
#include "deform/mesh.h"
#include "pattern/discretise.h"
#include "solve/placing_rules.h"
#include "solve/promise.h"
#include "solve/reconcile.h"
#include "symmetry/symmetry.h"

namespace seamwise {
namespace {

// What evening out may take of what a finished shape may change; the rest is left to the fit.
constexpr double kEvenedShare = 0.98;    ///< of the greatest change
constexpr double kEvenedAlready = 5e-7;  ///< cm that are no movement at all
constexpr double kEvenedKink = 12 * kPi / 180;
constexpr double kEvenedStretch = 0.12;
constexpr double kEvenedArea = 0.5;
constexpr double kEvenedSeam = 0.9 * kSeamTolerance;
constexpr double kFinest = 0.3;  ///< of the edge length asked for
constexpr double kRoom = 0.1;    ///< cm of movement that are enough for lengths to settle

std::string shown(double value, const char* format) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// Why a symmetry cannot hold, as "<symmetry>: <why>", and what to do about it.
struct Obstacle {
  std::size_t symmetry = 0;  ///< index among the imposed ones
  const char* code;          ///< of the note
  std::string why, remedy;
  std::vector<double> numbers = {};
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
                      "symmetryChange",
                      "its outlines would have to move by " + shown(moved, "%.2g") +
                          " cm to mirror each other exactly, which maxChangeCm does not allow",
                      "; raise maxChangeCm to " + shown(1.1 * moved, "%.2g"),
                      {1.1 * moved}};
    Limits limits;
    limits.moved = moved, limits.kink = kEvenedKink;
    limits.stretch = kEvenedStretch, limits.area = kEvenedArea;
    if (breachOf(piece, evened[p], limits) != Breach::kNone)
      return Obstacle{symmetry, "symmetryKinks",
                      "its outlines differ so much from edge to edge that they would get kinks or "
                      "folds if they were made to mirror each other exactly",
                      "; choose longer edges (edgeLengthCm), or draw them alike"};
  }
  for (const Seam& seam : pattern.seams) {
    double moved = 0;
    for (const int p : {seam.a.piece, seam.b.piece})
      if (p == m.pieces[0] || p == m.pieces[1])
        moved = std::max(moved, movedOf(pattern.pieces[p], evened[p]));
    if (moved > kEvenedAlready && max_change - moved < kRoom &&
        seamError(seam, evened) > kEvenedSeam)
      return Obstacle{symmetry,
                      "symmetryLengths",
                      "where its outlines are made to mirror each other exactly, seams lose their "
                      "length ratio, and maxChangeCm leaves no room to restore it",
                      "; raise maxChangeCm to " + shown(moved + kRoom, "%.2g"),
                      {moved + kRoom}};
  }
  return {};
}

/// @param sampled   what discretise() gives, where it is known
Outcome<Pattern> sampledAndMeshed(const Problem& problem, double edge_length,
                                  std::optional<Pattern> sampled) {
  if (sampled) return meshed(*std::move(sampled));
  Outcome<Pattern> now = discretise(problem.garment, problem.known, problem.imposed, edge_length);
  if (!now.ok()) return now.error();
  return meshed(std::move(now).value());
}

/// Drops a found symmetry, with a note. Error when it was asked for, with advice that ends the
/// sentence.
std::optional<Error> dropOrRefuse(Problem& problem, const Obstacle& obstacle, Failure code) {
  const BodySymmetry& symmetry = problem.imposed[obstacle.symmetry];
  const std::string name = called(problem.garment, symmetry);
  if (!problem.symmetries_optional)
    return Error{code,
                 "The symmetry of " + name + " cannot hold: " + obstacle.why + obstacle.remedy +
                     ", or leave out that symmetry.",
                 symmetry.pieces[0], -1, obstacle.code};
  problem.notes.push_back({obstacle.code,
                           "The symmetry of " + name + " is dropped: " + obstacle.why + ".",
                           piecesOf(symmetry),
                           {},
                           obstacle.numbers});
  problem.imposed.erase(problem.imposed.begin() + static_cast<std::ptrdiff_t>(obstacle.symmetry));
  return {};
}

/// No symmetry is left that pins or grain contradict. Errors: kSymmetryConflict when it was asked
/// for.
std::optional<Error> heedRules(Problem& problem) {
  const struct {
    std::optional<std::size_t> (*against)(const Problem&);
    const char *code, *why, *remedy;
  } rules[] = {
      {symmetryAgainstPins, "symmetryPins", "as it is pinned, the print does not mirror so",
       ". Move the pin"},
      {symmetryAgainstGrain, "symmetryGrain", "on this print it would take the piece off its grain",
       ". Turn the print, free the grain"}};
  for (const auto& rule : rules)
    while (const auto against = rule.against(problem))
      if (auto error = dropOrRefuse(problem, {*against, rule.code, rule.why, rule.remedy},
                                    Failure::kSymmetryConflict))
        return error;
  return {};
}

/// As preparedPattern(), after pins and grain.
Outcome<Pattern> made(Problem& problem) {
  Outcome<std::optional<Pattern>> reconciled = reconcile(problem);
  if (!reconciled.ok()) return reconciled.error();
  std::optional<Pattern> sampled = std::move(reconciled).value();
  const double max_change = problem.options.max_change_cm;
  double edge_length = problem.options.edge_length_cm;
  for (;;) {
    Outcome<Pattern> ready =
        sampledAndMeshed(problem, edge_length, std::exchange(sampled, std::nullopt));
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
          found = Obstacle{m, "symmetryCrossing",
                           "its outline would cross itself if it were made to mirror exactly", ""};
      if (!found || !problem.symmetries_optional) return ready.error();
    }
    if (const auto error = dropOrRefuse(problem, *found, Failure::kSymmetryDoesNotMirror))
      return *error;
  }
}

}  // namespace

Outcome<Pattern> preparedPattern(Problem& problem, MeshMemo* memo) {
  if (const auto error = heedRules(problem)) return *error;
  if (!memo) return made(problem);
  MeshMemo::Inputs from{problem.garment,
                        problem.imposed,
                        problem.known,
                        problem.symmetries_optional,
                        problem.options.edge_length_cm,
                        problem.options.max_change_cm};
  if (memo->last && memo->last->from == from) {
    problem.imposed = memo->last->imposed, problem.known = memo->last->known;
    const auto& notes = memo->last->notes;
    problem.notes.insert(problem.notes.end(), notes.begin(), notes.end());
    return memo->last->pattern;
  }
  const auto before = static_cast<std::ptrdiff_t>(problem.notes.size());
  Outcome<Pattern> pattern = made(problem);
  if (pattern.ok())
    memo->last = {std::move(from),
                  pattern.value(),
                  problem.imposed,
                  problem.known,
                  {problem.notes.begin() + before, problem.notes.end()},
                  nullptr,
                  nullptr};
  return pattern;
}

}  // namespace seamwise
