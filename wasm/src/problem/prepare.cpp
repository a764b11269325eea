#include "problem/prepare.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/decimal.h"
#include "deform/shape_limits.h"
#include "mesh/lengths.h"
#include "pattern/discretise.h"
#include "problem/placing_rules.h"
#include "problem/reconcile.h"
#include "symmetry/symmetry.h"
#include "tuning/progress.h"
#include "tuning/symmetry.h"

namespace seamwise {
namespace {

constexpr double kEvenedAlready = 5e-7;  ///< cm; less counts as no movement
constexpr double kEvenedSeam = SymmetryTuning::kEvenedSeamShare * kSeamTolerance;  ///< cm

/// The reason why a symmetry cannot hold, as "<symmetry>: <why>", and a remedy.
struct Obstacle {
  std::size_t symmetry = 0;  ///< index among the imposed ones
  const char* code;          ///< code of the note
  std::string why, remedy;
  std::vector<double> numbers = {};
};

/// True if edges of a seam deviate from their length ratio and the pieces may not move far enough
/// to restore it. Either one side bends more than the other, or several seams and symmetries
/// determine the spacing of its vertices. The error shrinks with the edge length.
bool isStiff(const Pattern& pattern, const Shapes& evened, double max_change) {
  return max_change < SymmetryTuning::kSettlingReach &&
         std::any_of(pattern.seams.begin(), pattern.seams.end(),
                     [&](const Seam& seam) { return seamError(seam, evened) > kEvenedSeam; });
}

/// Finds a limit that the evened pattern exceeds because of a symmetry. Shaping starts from the
/// evened pattern and falls back to it, so it must keep every limit.
std::optional<Obstacle> obstacle(const Pattern& pattern, std::size_t symmetry, const Shapes& evened,
                                 double max_change) {
  const Mirror& m = pattern.mirrors[symmetry];
  for (const int p : m.pieces) {
    const Piece& piece = pattern.pieces[p];
    const double moved = pieceMovement(piece, evened[p]);
    if (moved > std::max(SymmetryTuning::kEvenedShare * max_change, kEvenedAlready))
      return Obstacle{symmetry,
                      "symmetryChange",
                      "its outlines would have to move by " + significant(moved, 2) +
                          " cm to mirror each other exactly, which maxChangeCm does not allow",
                      "; raise maxChangeCm to " + significant(1.1 * moved, 2),
                      {1.1 * moved}};
    ShapeLimits limits = kEvenedLimits;
    limits.moved = moved;
    if (brokenLimit(piece, evened[p], limits) != BrokenLimit::kNone)
      return Obstacle{symmetry, "symmetryKinks",
                      "its outlines differ so much from edge to edge that they would get kinks or "
                      "folds if they were made to mirror each other exactly",
                      "; choose longer edges (edgeLengthCm), or draw them alike"};
  }
  for (const Seam& seam : pattern.seams) {
    double moved = 0;
    for (const int p : {seam.a.piece, seam.b.piece})
      if (p == m.pieces[0] || p == m.pieces[1])
        moved = std::max(moved, pieceMovement(pattern.pieces[p], evened[p]));
    if (moved > kEvenedAlready && max_change - moved < SymmetryTuning::kSettlingReach &&
        seamError(seam, evened) > kEvenedSeam)
      return Obstacle{
          symmetry,
          "symmetryLengths",
          "where its outlines are made to mirror each other exactly, seams lose their "
          "length ratio, and maxChangeCm leaves no room to restore it",
          "; raise maxChangeCm to " + significant(moved + SymmetryTuning::kSettlingReach, 2),
          {moved + SymmetryTuning::kSettlingReach}};
  }
  return {};
}

/// Drops a detected symmetry, with a note. A requested one causes an error that ends with the
/// remedy.
std::optional<Error> dropOrRefuse(const Garment& garment, const Obstacle& obstacle, Failure code,
                                  GarmentSymmetries& symmetries, std::vector<Note>& notes) {
  const auto at = symmetries.imposed.begin() + static_cast<std::ptrdiff_t>(obstacle.symmetry);
  const std::string name = called(garment, *at);
  if (!symmetries.optional)
    return Error{code,
                 "The symmetry of " + name + " cannot hold: " + obstacle.why + obstacle.remedy +
                     ", or leave out that symmetry.",
                 at->pieces[0], -1, obstacle.code};
  notes.push_back({obstacle.code,
                   "The symmetry of " + name + " is dropped: " + obstacle.why + ".",
                   piecesOf(*at),
                   {},
                   obstacle.numbers});
  symmetries.imposed.erase(at);
  return {};
}

}  // namespace

Preparation::Preparation(const Problem& problem, GarmentSymmetries symmetries, MeshMemo* memo)
    : problem_(problem), memo_(memo), edge_length_(problem.options.edge_length_cm) {
  made_.symmetries = std::move(symmetries);
  made_.plans = std::make_shared<MeshPlans>();
}

/// Drops symmetries that pins or grain contradict. Errors: kSymmetryConflict for a requested one.
std::optional<Error> Preparation::enforceRules() {
  const struct {
    std::optional<std::size_t> (*against)(const Problem&, const std::vector<BodySymmetry>&);
    const char *code, *why, *remedy;
  } rules[] = {
      {symmetryAgainstPins, "symmetryPins", "as it is pinned, the print does not mirror so",
       ". Move the pin"},
      {symmetryAgainstGrain, "symmetryGrain", "on this print it would take the piece off its grain",
       ". Turn the print, free the grain"}};
  for (const auto& rule : rules)
    while (const auto against = rule.against(problem_, made_.symmetries.imposed))
      if (auto error = dropOrRefuse(problem_.garment, {*against, rule.code, rule.why, rule.remedy},
                                    Failure::kSymmetryConflict, made_.symmetries, rule_notes_))
        return error;
  return {};
}

bool Preparation::advance() {
  if (ended_) return false;
  if (!begun_) return begin();
  if (!meshing_) return sample();
  if (!meshing_->advance()) return judge(std::exchange(meshing_, std::nullopt)->take());
  fraction_ = std::max(
      fraction_, ProgressTuning::kSampled + (1 - ProgressTuning::kSampled) * meshing_->fraction());
  return true;
}

bool Preparation::begin() {
  begun_ = true;
  if (const auto error = enforceRules()) return end(*error);
  if (memo_) {
    from_ = {problem_.garment, made_.symmetries, problem_.options.edge_length_cm,
             problem_.options.max_change_cm};
    if (memo_->last && memo_->last->from == *from_) {
      made_ = memo_->last->made;
      ended_ = true;
      return false;
    }
  }
  Outcome<Reconciled> reconciled = reconcile(problem_, made_.symmetries);
  if (!reconciled.ok()) return end(reconciled.error());
  Reconciled& left = reconciled.value();
  made_.symmetries = std::move(left.symmetries);
  made_.notes = std::move(left.notes);
  sampled_ = std::move(left.sampled);
  fraction_ = ProgressTuning::kReconciled;
  return true;
}

bool Preparation::sample() {
  if (!sampled_) {
    Outcome<Pattern> now = discretise(problem_.garment, made_.symmetries.known,
                                      made_.symmetries.imposed, edge_length_);
    if (!now.ok()) return judge(now.error());
    sampled_ = std::move(now).value();
  }
  meshing_.emplace(*std::exchange(sampled_, std::nullopt), MeshTuning::kCoarsest,
                   &problem_.garment.panels);
  fraction_ = std::max(fraction_, ProgressTuning::kSampled);
  return true;
}

/// Checks the mesh. Returns true to continue with a finer sampling or fewer symmetries.
bool Preparation::judge(Outcome<Pattern> ready) {
  std::optional<Obstacle> found;
  if (ready.ok()) {
    const Pattern& pattern = ready.value();
    const double max_change = problem_.options.max_change_cm;
    const Shapes evened = evenedShapes(pattern);
    for (std::size_t m = 0; m < pattern.mirrors.size() && !found; ++m)
      found = obstacle(pattern, m, evened, max_change);
    if (!found && edge_length_ > SymmetryTuning::kFinestShare * problem_.options.edge_length_cm &&
        isStiff(pattern, evened, max_change)) {
      edge_length_ /= 2;
      return true;
    }
    if (!found) return end(std::move(ready));
  } else {
    // A piece that cannot be meshed as its own mirror image is meshed without that symmetry.
    const std::vector<BodySymmetry>& imposed = made_.symmetries.imposed;
    for (std::size_t m = 0; m < imposed.size() && !found; ++m)
      if (imposed[m].pieces[0] == ready.error().piece)
        found = Obstacle{m, "symmetryCrossing",
                         "its outline would cross itself if it were made to mirror exactly", ""};
    if (!found || !made_.symmetries.optional) return end(ready.error());
  }
  if (const auto error = dropOrRefuse(problem_.garment, *found, Failure::kSymmetryDoesNotMirror,
                                      made_.symmetries, made_.notes))
    return end(*error);
  return true;
}

bool Preparation::end(Outcome<Pattern> pattern) {
  fraction_ = 1;
  ended_ = true;
  if (pattern.ok()) {
    made_.pattern = std::move(pattern).value();
    if (memo_) memo_->last = {*std::move(from_), made_};
  } else {
    error_ = pattern.error();
  }
  return false;
}

Outcome<Prepared> Preparation::take() {
  if (error_) return *error_;
  made_.notes.insert(made_.notes.begin(), rule_notes_.begin(), rule_notes_.end());
  return std::move(made_);
}

Outcome<Prepared> prepared(const Problem& problem, MeshMemo* memo) {
  Preparation preparation(problem, problem.symmetries, memo);
  while (preparation.advance()) {
  }
  return preparation.take();
}

}  // namespace seamwise
