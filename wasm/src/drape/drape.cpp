#include "drape/drape.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/decimal.h"

namespace seamwise {
namespace {

constexpr int kQuasiNewtonSteps = 24;
constexpr int kSewingSteps = 5, kHangingSteps = 40, kSettlingSteps = 60;  ///< Newton, at most
/// A step is quiet when no vertex moves further [m] and the energy falls by less than that share of
/// what lifts the garment by a metre.
constexpr double kQuiet = 5e-4, kQuietFall = 2e-5;

int mostSteps(Drape::Stage stage) {
  switch (stage) {
    case Drape::Stage::kSew:
      return kQuasiNewtonSteps + kSewingSteps;
    case Drape::Stage::kHang:
      return kHangingSteps;
    default:
      return kSettlingSteps;
  }
}

}  // namespace

Drape::Drape(DrapeProblem problem)
    : problem_(std::move(problem)),
      coarse_(sewnMesh(problem_.levels.coarse,
                       shapesOf(problem_.levels.coarse, problem_.pattern, problem_.shapes),
                       problem_.warp)),
      fine_(sewnMesh(problem_.levels.fine,
                     shapesOf(problem_.levels.fine, problem_.pattern, problem_.shapes),
                     problem_.warp)) {
  if (!problem_.settled.empty()) {
    begin(Stage::kSettle, problem_.settled);
    return;
  }
  ClothOptions options = problem_.options;
  options.friction = false;
  solver_ = std::make_unique<ClothSolver>(coarse_, problem_.fabric, *problem_.body, problem_.start,
                                          std::move(options));
  begin(Stage::kSew);
}

const SewnLevel& Drape::level() const {
  return stage_ == Stage::kSew || stage_ == Stage::kHang ? problem_.levels.coarse
                                                         : problem_.levels.fine;
}

double Drape::fraction() const {
  if (stage_ == Stage::kDone) return 1;
  constexpr std::array<double, 3> kBefore{0, 0.1, 0.3}, kShare{0.1, 0.2, 0.7};  // of the work
  const auto k = static_cast<std::size_t>(stage_);
  const double within = static_cast<double>(stages_.back().steps) / mostSteps(stage_);
  return std::max(kBefore[k] + kShare[k] * within, std::min(1.0, work() / problem_.budget));
}

void Drape::begin(Stage stage, const Positions& from) {
  stage_ = stage, quiet_ = 0;
  if (stage == Stage::kHang) solver_->setFriction(problem_.options.friction);
  if (stage == Stage::kSettle) {
    if (solver_) spent_ += solver_->work();
    solver_ = std::make_unique<ClothSolver>(fine_, problem_.fabric, *problem_.body, from,
                                            problem_.options);
  }
  began_ = work();
  if (stage != Stage::kDone)
    stages_.push_back({stage, static_cast<int>(positions().size()), 0, 0, {solver_->energy()}});
}

void Drape::step() {
  StageReport& report = stages_.back();
  const bool first = stage_ == Stage::kSew && report.steps < kQuasiNewtonSteps;
  const ClothSolver::Step step = first ? solver_->quasiNewtonStep() : solver_->newtonStep();
  ++report.steps;
  report.work = work() - began_;
  report.energies.push_back(step.energy);
  farthest_ = step.farthest;
  const bool quiet =
      step.failed || (step.farthest < kQuiet && step.fall < kQuietFall * solver_->weight());
  quiet_ = quiet && !first ? quiet_ + 1 : 0;
}

void Drape::finish() {
  if (!std::isfinite(solver_->energy())) {
    notes_.emplace_back("The garment cannot be draped: it has no position to start from.");
  } else if (!atRest()) {
    const int millimetres = static_cast<int>(1000 * farthest_ + 0.5);
    notes_.push_back("The garment is still moving by " +
                     (millimetres < 1 ? "less than 1" : decimal(millimetres)) + " mm in a step.");
  }
  check_ = checkDrape(fine_, positions(), *problem_.body);
  begin(Stage::kDone);
}

bool Drape::advance(double work_now) {
  const double until = work() + work_now;
  while (stage_ != Stage::kDone && work() < until) {
    step();
    const bool over = atRest() || stages_.back().steps >= mostSteps(stage_);
    if (stage_ == Stage::kSettle && (over || work() >= problem_.budget))
      finish();
    else if (over && stage_ == Stage::kSew)
      begin(Stage::kHang);
    else if (over)
      begin(Stage::kSettle, prolonged(problem_.levels, positions()));
  }
  return stage_ != Stage::kDone;
}

}  // namespace seamwise
