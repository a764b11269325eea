#include "drape/drape.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/decimal.h"
#include "base/sort_by.h"
#include "drape/pleat_ties.h"

namespace seamwise {
namespace {

constexpr int kMostMended = 3, kMendingSteps = 12;
constexpr int kQuasiNewtonSteps = 24;
constexpr int kSewingSteps = 2, kHangingSteps = 80, kSettlingSteps = 60;  ///< maximum Newton steps
/// Maximum steps of full garments on the fine mesh in a fabric that yields; their folds grow there.
constexpr int kYieldingSteps = 30;
/// Steps of each start after sewing. The order of energies then is the order at rest.
constexpr int kTrialSteps = 10;
/// Steps end once further steps are predicted to lower its energy by less than this
/// share of the energy that lifts it by a metre.
constexpr double kRestFall = 1.5e-4;
constexpr int kRestSteps = 5;
/// Limits of the share by which the energy falls more slowly from kRestSteps steps to the next.
constexpr double kFastest = 0.8, kSlowest = 0.9;
/// Largest ratio of the distance from rest to the extrapolated one: 0.2 to 3.2 in eight samples,
/// after steps with more iterations until nothing moved (docs/experiments.md).
constexpr double kFurther = 3.2;
/// Long steps and many iterations; a sheet needs both to fold.
constexpr double kLongestStep = 1;  ///< s
constexpr int kMostIterations = 60;

/// Stretch stiffness of the fabric on the coarse mesh over its density: a skirt's own weight
/// stretches it by 0.5 %. [m2/s2]
constexpr double kYielding = 1500;
/// Strain from which that fabric is stiff, so that a band remains tight, and its stiffness there
/// relative to the real fabric.
constexpr double kYieldingTo = 0.01, kBeyond = 2;

/// Distance of pleats' layers on the coarse mesh relative to the fine one. [1]
constexpr double kCoarsePleats = 2;
/// Maximum movement of a pleated garment in a step, about the distance between its layers. [m]
constexpr double kPleatStep = 0.005;

/// Free edges that start closer than this to the plane x = 0 may meet others there. [m]
constexpr double kBesidePlane = 0.03;

/// Returns the edges of exactly one triangle, in its direction of rotation.
std::vector<std::pair<int, int>> freeEdges(const SewnMesh& mesh) {
  std::vector<std::pair<int, int>> sides, free;
  for (const SewnMesh::Triangle& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) sides.emplace_back(t.vertices[k], t.vertices[(k + 1) % 3]);
  sortOnce(sides);
  for (const auto& [a, b] : sides)
    if (!std::binary_search(sides.begin(), sides.end(), std::pair(b, a))) free.emplace_back(a, b);
  return free;
}

/// Returns a fabric that stretches more easily. Folds move as far in a step as the stretch between
/// them allows, and conjugate gradients need fewer iterations the closer stretch and bending are. A
/// coarse mesh also folds too little where it cannot stretch.
Fabric yielding(Fabric fabric) {
  const double factor = fabric.warp / (kYielding * fabric.density);
  if (factor <= 1) return fabric;
  for (double Fabric::*const stiffness : {&Fabric::warp, &Fabric::weft, &Fabric::coupling})
    fabric.*stiffness /= factor;
  fabric.stiff_from = kYieldingTo, fabric.stiffening = kBeyond * factor;
  return fabric;
}

double rmsBetween(const Positions& a, const Positions& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec3 moved = a[i] - b[i];
    sum += dot(moved, moved);
  }
  return std::sqrt(sum / static_cast<double>(a.size()));
}

}  // namespace

Drape::Drape(DrapeProblem problem)
    : problem_(std::move(problem)),
      yielding_(yielding(problem_.fabric)),
      coarse_(sewnMesh(problem_.levels.coarse,
                       shapesOf(problem_.levels.coarse, problem_.pattern, problem_.shapes),
                       problem_.warp)),
      fine_(sewnMesh(problem_.levels.fine,
                     shapesOf(problem_.levels.fine, problem_.pattern, problem_.shapes),
                     problem_.warp)) {
  if (problem_.settled.empty())
    begin(Stage::kSew, problem_.start);
  else
    begin(Stage::kSettle, problem_.settled);
}

const SewnLevel& Drape::level() const {
  return stage_ == Stage::kSew || stage_ == Stage::kHang ? problem_.levels.coarse
                                                         : problem_.levels.fine;
}

int Drape::mostSteps(Stage stage) const {
  if (stage == Stage::kSew) return kQuasiNewtonSteps + kSewingSteps;
  return static_cast<int>(problem_.effort *
                          (stage == Stage::kHang ? kHangingSteps : kSettlingSteps));
}

/// Returns the larger of the share of the budget and the share of the usual steps.
double Drape::progress() const {
  if (stage_ == Stage::kDone) return 1;
  constexpr std::array<double, 3> kBefore{0, 0.1, 0.3}, kShare{0.1, 0.2, 0.7};  // work shares
  const auto k = static_cast<std::size_t>(stage_);
  const double within = static_cast<double>(stages_.back().steps) / last_step_;
  // Steps that separate crossings are not included, so `within` may exceed 1.
  return std::min(1.0, std::max(kBefore[k] + kShare[k] * within, work() / problem_.budget));
}

/// Returns per vertex the side of x = 0 that it keeps: ClothOptions::least_x. It binds trouser legs
/// and free edges that run along the plane close to it, such as fronts that meet unbuttoned and
/// ends of collars.
std::vector<double> Drape::besideEachOther(const SewnLevel& level, const SewnMesh& mesh,
                                           const HeldLayers& held, const Positions& x) const {
  const double apart = problem_.fabric.offset / 2;
  std::vector<double> least(x.size(), 0.0);
  for (const auto& [a, b] : freeEdges(mesh)) {
    const Vec3 along = x[b] - x[a];
    if (std::abs(along.x()) > std::abs(along.y())) continue;
    if (std::abs(x[a].x() + x[b].x()) > 2 * kBesidePlane) continue;
    for (const int v : {a, b})
      if (held.laps[v] == 0) least[v] = x[v].x() < 0 ? -apart : x[v].x() > 0 ? apart : 0;
  }
  for (std::size_t p = 0; p < problem_.legs.size(); ++p)
    for (const int v : level.sewn[p])
      if (x[v].y() < problem_.crotch) least[v] = problem_.legs[p] * apart;
  return least;
}

void Drape::put(const SewnLevel& level, const SewnMesh& mesh, const Positions& from) {
  if (cloth_) spent_ += cloth_->work();
  const bool pleated = !level.pleats.empty();
  LevelCloth::Layers layers{problem_.overlaps, {}, {}, problem_.fabric.offset};
  // Large triangles of pleats cut the curves of the body short.
  if (pleated && &level == &problem_.levels.coarse) layers.gap *= kCoarsePleats;
  layers.held = heldLayers(level, problem_.matches, problem_.overlaps, layers.gap);
  for (const ClothTie& tie : pleatTies(level, layers.gap)) layers.held.ties.push_back(tie);
  // A garment without pleats or overlapping pieces has no layers; waves of its cloth only resemble
  // them.
  if (pleated || !problem_.overlaps.empty()) {
    if (stage_ == Stage::kSew)
      layers.laid = problem_.start;
    else if (problem_.settled.empty())
      layers.laid = prolonged(problem_.levels, problem_.start);
    else
      layers.laid = problem_.settled;
  }
  ClothOptions options = problem_.options;
  options.longest_step = kLongestStep;
  options.most_iterations = kMostIterations;
  if (pleated && stage_ == Stage::kSew) options.farthest = options.farthest_near = kPleatStep;
  options.least_x = besideEachOther(level, mesh, layers.held, from);
  cloth_ =
      std::make_unique<LevelCloth>(mesh, level.image, layers, yields_ ? yielding_ : problem_.fabric,
                                   *problem_.body, from, std::move(options));
}

void Drape::begin(Stage stage, const Positions& from) {
  since_ = {}, last_fall_ = 0;
  stage_ = stage, last_step_ = mostSteps(stage);
  if (stage == Stage::kDone) return;
  settled_ = false;
  yields_ = stage != Stage::kSettle || (problem_.other_starts > 0 && problem_.settled.empty());
  if (stage == Stage::kSew) {
    put(problem_.levels.coarse, coarse_, from);
    cloth_->setFriction(problem_.options.friction && problem_.by_band);
    cloth_->setTouching(cloth_->hasLayers());
  } else if (stage == Stage::kHang) {
    cloth_->setFriction(problem_.options.friction);
    cloth_->untangle();
  } else {
    put(problem_.levels.fine, fine_, from);
    cloth_->setTouching(true);
  }
  began_ = work();
  stages_.push_back({stage, static_cast<int>(positions().size()), 0, 0, {cloth_->energy()}});
}

void Drape::step() {
  StageReport& report = stages_.back();
  const bool first = stage_ == Stage::kSew && report.steps < kQuasiNewtonSteps;
  // The garment first settles on the body without weight: a band that fell meanwhile would stay too
  // low.
  cloth_->setWeight(!first);
  if (since_.steps == 0) since_.from = cloth_->positions();
  const ClothSolver::Step step = first ? cloth_->quasiNewtonStep() : cloth_->newtonStep();
  ++report.steps;
  report.work = work() - began_;
  report.energies.push_back(step.energy);
  farthest_ = step.farthest;
  if (!first) watch(step.fall);
}

/// Updates the distance from rest once in kRestSteps steps. If the energy falls by a constant
/// factor, the fall ahead is a geometric series. Distances fall by the root of that factor, because
/// the energy is quadratic near rest.
void Drape::watch(double fall) {
  since_.fall += fall;
  if (++since_.steps < kRestSteps) return;
  const double rate = std::clamp(since_.fall / last_fall_, kFastest, kSlowest);
  const double root = std::sqrt(rate);
  settled_ = last_fall_ > 0 &&
             since_.fall * rate / (1 - rate) < kRestFall / problem_.effort * cloth_->weight();
  from_rest_ = kFurther * rmsBetween(since_.from, cloth_->positions()) * root / (1 - root);
  last_fall_ = since_.fall;
  since_ = {};
}

/// Forgets the fall of energy, which is of other steps than those that follow.
void Drape::forgetFall() { since_ = {}, last_fall_ = 0, settled_ = false; }

/// Ends the steps in a fabric that yields.
void Drape::stiffen() {
  const Positions now = positions();
  yields_ = false;
  put(problem_.levels.fine, fine_, now);
  cloth_->setTouching(true);
  forgetFall();
  last_step_ = stages_.back().steps + mostSteps(Stage::kSettle);
}

/// Stores a start that has hung if it is the best one, and begins the next one. After the last one
/// it continues with the best one.
void Drape::tryNextStart() {
  if (!best_.cloth || !(best_.cloth->energy() <= cloth_->energy())) {
    std::swap(best_.cloth, cloth_);
    best_.start = problem_.start, best_.stages = stages_;
  }
  if (cloth_) spent_ += cloth_->work();
  cloth_ = nullptr;
  if (tried_ < problem_.other_starts) {
    problem_.start = problem_.other_start(tried_++);
    stages_.clear();
    begin(Stage::kSew, problem_.start);
    return;
  }
  Trial best = std::move(best_);
  cloth_ = std::move(best.cloth), best_.cloth = nullptr;
  problem_.start = std::move(best.start), stages_ = std::move(best.stages);
  began_ = stages_.front().work;  // the other starts count as hanging
  forgetFall();
}

void Drape::finish() {
  if (!std::isfinite(cloth_->energy())) {
    notes_.push_back(
        {"drapeNoStart", "The garment cannot be draped: it has no position to start from."});
  } else if (!settled_) {
    const int millimetres = static_cast<int>(std::nearbyint(1000 * farthest_));
    notes_.push_back({"drapeMoving",
                      "The garment is still moving by " +
                          (millimetres < 1 ? "less than 1" : decimal(millimetres)) +
                          " mm in a step.",
                      {},
                      {},
                      {100 * farthest_}});
  }
  check_ = checkDrape(fine_, positions(), *problem_.body);
  if (std::optional<Note> doubt = doubtAbout(check_)) notes_.push_back(*std::move(doubt));
  begin(Stage::kDone);
}

/// Starts another round of steps if crossings are left, or if the cloth has to come to rest after
/// such rounds. Returns whether it did.
bool Drape::mend() {
  if (mended_ >= kMostMended || work() >= problem_.budget) return false;
  if (cloth_->crossings() > 0)
    ++mended_;
  else if (mended_ > 0 && !settled_)
    mended_ = kMostMended;
  else
    return false;
  forgetFall();
  last_step_ = stages_.back().steps + kMendingSteps;
  cloth_->setTouching(true);
  cloth_->untangle();
  return true;
}

bool Drape::advance(double work_now) {
  const double until = work() + work_now;
  while (stage_ != Stage::kDone && work() < until) {
    step();
    fraction_ = std::max(fraction_, progress());
    if (stage_ == Stage::kSettle && yields_ &&
        (settled_ || stages_.back().steps >= kYieldingSteps || work() >= problem_.budget))
      stiffen();
    const bool over = settled_ || stages_.back().steps >= last_step_ || work() >= problem_.budget;
    const bool trial = best_.cloth || tried_ < problem_.other_starts;
    if (trial && stage_ == Stage::kHang) {
      if (over || stages_.back().steps >= kTrialSteps) tryNextStart();
    } else if (over && stage_ == Stage::kSettle) {
      if (!mend()) finish();
    } else if (over && stage_ == Stage::kSew)
      begin(Stage::kHang);
    else if (over)
      begin(Stage::kSettle, prolonged(problem_.levels, positions()));
  }
  if (stage_ == Stage::kDone) fraction_ = 1;
  return stage_ != Stage::kDone;
}

}  // namespace seamwise
