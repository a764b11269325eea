#include "alignment/bound/lower_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "alignment/icp/refine.h"
#include "tuning/proof.h"
#include "tuning/search.h"

namespace seamwise {
namespace {

constexpr double kSumError = 1e-6;  ///< greatest relative error of a sum in single precision

/// Priority that grows with the gain and, at equal gain, falls with the number of boxes: gain /
/// boxes^0.4, to the fifth power, since only the order counts.
double fewFirst(double gain, double boxes) {
  const double squared = gain * gain;
  return squared * squared * gain / (boxes * boxes);
}

}  // namespace

LowerBound::LowerBound(const MatchProblem& problem, const Component& component,
                       const Alignments& known)
    : problem_(problem),
      edges_(problem, 0),
      seams_(component.seams),
      tables_(problem, component),
      best_(known) {
  cost_ = costAt(known);
}

bool LowerBound::step() {
  if (proven() || ended_) return false;
  next();
  return !proven() && !ended_;
}

void LowerBound::next() {
  switch (stage_) {
    case Stage::kSweep:
      if (tables_.step(ProofTuning::kStepWork, spent_)) return;
      tighten();
      stage_ = Stage::kDrop;
      return;
    case Stage::kDrop:
      tables_.drop(static_cast<float>(enough() * (1 + kSumError)));
      if (tables_.all(0).empty()) bound_ = std::max(bound_, enough());
      stage_ = proven() || tables_.evaluate() ? Stage::kSweep : Stage::kTilt;
      return;
    case Stage::kTilt:
      tables_.tilt();
      stage_ = Stage::kHalve;
      return;
    case Stage::kHalve:
      ended_ = !halve();
      if (!ended_ && !tables_.evaluate()) tables_.sweep();
      stage_ = Stage::kSweep;
  }
}

/// Updates the bound after a sweep, and tries to find a better answer.
void LowerBound::tighten() {
  bound_ = std::max(bound_, std::min(tables_.sums().total() * (1 - kSumError), enough()));
  if (!proven()) descend();
}

/// Halves the boxes of one leader that keep the bound low. Prefers the leader whose points move
/// most. Returns false if nothing can be halved within the memory limit.
bool LowerBound::halve() {
  const double least = tables_.sums().total(), above = std::max(0.0, enough() - least);
  for (double share = ProofTuning::kHalvedShare; share > 1e-3; share /= 2) {
    const float below = std::nextafter(static_cast<float>(least + share * above),
                                       std::numeric_limits<float>::max());
    int best = -1;
    double most = 0;
    for (int v = 0; v < tables_.leaders(); ++v) {
      double movement = 0, count = 0;
      for (std::size_t i = 0; i < tables_.all(v).size(); ++i) {
        if (tables_.sums().least[v][i] >= below) continue;
        movement += tables_.boxes(v).movement(tables_.all(v)[i]);
        ++count;
      }
      if (count == 0) continue;
      const double gain = fewFirst(movement / count * tables_.weight(v), count);
      if (gain > most && tables_.bytesWith(v, below) < ProofTuning::kMemory) most = gain, best = v;
    }
    if (best < 0) continue;
    tables_.halve(best, below, spent_);
    return true;
  }
  return false;
}

double LowerBound::costAt(const Alignments& at) const {
  double cost = 0;
  for (const int s : seams_) {
    const int a = problem_.seams[s].a, b = problem_.seams[s].b;
    cost += edges_.cost(s, edges_.pose(a, at[a]), edges_.pose(b, at[b]), 0);
  }
  return cost;
}

/// Improves the answer in the middle of the boxes with the least bounds, and stores it if it is the
/// best.
void LowerBound::descend() {
  if (descents_ > ProofTuning::kDescentShare * spent_) return;
  Alignments at = best_;
  std::vector<Alignment> middles;
  std::vector<int> active;
  for (int v = 0; v < tables_.leaders(); ++v) {
    const std::vector<float>& least = tables_.sums().least[v];
    const auto box = std::min_element(least.begin(), least.end()) - least.begin();
    const int l = tables_.boxes(v).leader();
    const Leader& leader = problem_.leaders[l];
    middles.push_back(tables_.all(v)[box].at);
    at[l] = leader.admissible.nearest(middles.back(), leader.centre);
    active.push_back(l);
  }
  if (middles == tried_) return;
  tried_ = middles;
  double edges = 0;
  for (const int s : seams_) edges += static_cast<double>(problem_.seams[s].w.size());
  // Each step evaluates the cost and the model.
  const double work = 3 * ProofTuning::kDescentIterations * edges *
                      static_cast<double>(4 + problem_.group.elements().size());
  spent_ += work, descents_ += work;
  refine(problem_, edges_, at, active, ProofTuning::kDescentIterations);
  const double refined = costAt(at);
  if (refined < cost_) cost_ = refined, best_ = std::move(at);
}

double LowerBound::bound() const { return std::min(cost_, bound_); }

bool LowerBound::proven() const {
  return cost_ < SearchTuning::kPerfectDistance * edges_.weight() || bound() >= enough();
}

}  // namespace seamwise
