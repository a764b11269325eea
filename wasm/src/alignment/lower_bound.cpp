#include "alignment/lower_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "alignment/refine.h"

namespace seamwise {
namespace {

constexpr double kDescents = 0.1;   ///< share of the evaluations that go into better answers
constexpr int kIterations = 12;     ///< of a descent, at most
constexpr double kNode = 20;        ///< evaluations that a known seam of a box costs as much as
constexpr double kFine = 0.12;      ///< share of the shortest repeat at which boxes begin to tell
constexpr double kEasierFirst = 2;  ///< an effort of one halving more counts as so much work

}  // namespace

BoxSearch::BoxSearch(const MatchProblem& problem, const SampledSeams<double>& edges,
                     const std::vector<int>& seams, const Alignments& known)
    : problem_(problem), edges_(edges), best_(known) {
  bool free = true;
  for (const int s : seams)
    for (const int l : {problem.seams[s].a, problem.seams[s].b})
      free = free && !problem.leaders[l].freedom.isPinned();
  std::vector<int> index(problem.leaders.size(), -1);
  for (const int s : seams) {
    const MatchSeam& seam = problem.seams[s];
    for (const int l : {seam.a, seam.b}) {
      if (index[l] >= 0) continue;
      index[l] = static_cast<int>(boxes_.size());
      boxes_.emplace_back(problem, l, free && boxes_.empty());
    }
    joints_.push_back({index[seam.a], index[seam.b], SeamBound(problem, seam), {}, {}});
  }
  cost_ = costAt(known);
  Node root{0, std::vector<int>(boxes_.size(), 0), {}};
  for (Joint& joint : joints_) root.pairs.push_back(pairOf(joint, 0, 0));
  root.bound = boundOf(root);
  open_.push_back(std::move(root));
}

int BoxSearch::pairOf(Joint& joint, int a, int b) {
  spent_ += kNode;
  const auto [found, fresh] =
      joint.known.try_emplace((static_cast<std::uint64_t>(a) << 32) + static_cast<std::uint64_t>(b),
                              static_cast<int>(joint.pairs.size()));
  if (fresh) {
    const Boxes &of_a = boxes_[joint.a], &of_b = boxes_[joint.b];
    joint.pairs.push_back(
        joint.bound.between(of_a[a], of_a.reach(), of_b[b], of_b.reach(), spent_));
  }
  return found->second;
}

/// Seams whose slopes say little count with their flat bounds.
double BoxSearch::boundOf(const Node& node) const {
  double apart = 0, together = 0;
  std::vector<double> slopes(3 * boxes_.size(), 0);
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const Joint& joint = joints_[j];
    const SeamBound::Pair& pair = joint.pairs[node.pairs[j]];
    apart += pair.bound();
    if (pair.flat >= pair.middle - pair.steepness() / 2) {
      together += pair.flat;
      continue;
    }
    together += pair.middle;
    for (int k = 0; k < 3; ++k)
      slopes[3 * joint.a + k] += pair.slope[k], slopes[3 * joint.b + k] += pair.slope[3 + k];
  }
  for (const double g : slopes) together -= std::abs(g);
  return std::max(apart, together);
}

/// The leader whose box to split, -1 if none can be: of the seam that promises most for the least
/// effort the side that moves more.
int BoxSearch::choice(const Node& node) const {
  const double fine = kFine * problem_.group.reducedBasis()[0].norm();
  int best = -1;
  double most = -1;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const Joint& joint = joints_[j];
    const Boxes &of_a = boxes_[joint.a], &of_b = boxes_[joint.b];
    const int a = node.boxes[joint.a], b = node.boxes[joint.b];
    const auto moves = [](const Boxes& boxes, int box) {
      return boxes[box].open ? std::numeric_limits<double>::infinity()
                             : boxes[box].turn * boxes.reach() + boxes[box].shift();
    };
    const double by_a = moves(of_a, a), by_b = moves(of_b, b);
    if (!(by_a + by_b > 0)) continue;
    const double effort =
        1 + of_a.effort(a, fine) + (joint.a == joint.b ? 0 : of_b.effort(b, fine));
    const SeamBound::Pair& pair = joint.pairs[node.pairs[j]];
    const double gain =
        of_a[a].open || of_b[b].open ? joint.bound.seam().weight * fine : pair.cost - pair.bound();
    if (gain / (effort * effort) > most)
      most = gain / (effort * effort), best = by_a >= by_b ? joint.a : joint.b;
  }
  return best;
}

void BoxSearch::step() {
  if (open_.empty()) return;
  std::pop_heap(open_.begin(), open_.end());
  const Node node = std::move(open_.back());
  open_.pop_back();
  const int split = choice(node);
  if (split < 0) return descend(node);  // a single alignment
  for (const int box : boxes_[split].split(node.boxes[split])) {
    Node child = node;
    child.boxes[split] = box;
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      Joint& joint = joints_[j];
      if (joint.a == split || joint.b == split)
        child.pairs[j] = pairOf(joint, child.boxes[joint.a], child.boxes[joint.b]);
    }
    child.bound = std::max(node.bound, boundOf(child));
    if (child.bound >= cost_) continue;
    open_.push_back(std::move(child));
    std::push_heap(open_.begin(), open_.end());
  }
  if (!open_.empty() && descents_ < kDescents * spent_) descend(open_.front());
}

double BoxSearch::costAt(const Alignments& at) const {
  double cost = 0;
  for (const Joint& joint : joints_) {
    const int a = joint.bound.seam().a, b = joint.bound.seam().b;
    cost += edges_.cost(static_cast<int>(&joint.bound.seam() - problem_.seams.data()),
                        edges_.pose(a, at[a]), edges_.pose(b, at[b]), 0);
  }
  return cost;
}

/// Improves the answer in the middle of a box, and keeps it if it is the best.
void BoxSearch::descend(const Node& node) {
  Alignments at = best_;
  std::vector<int> active;
  double edges = 0;
  for (std::size_t k = 0; k < boxes_.size(); ++k) {
    const int l = boxes_[k].leader();
    const Leader& leader = problem_.leaders[l];
    at[l] = leader.freedom.nearest(boxes_[k][node.boxes[k]].at, leader.centre);
    if (!leader.freedom.isPinned()) active.push_back(l);
  }
  // each step of it counts the cost and the model
  for (const Joint& joint : joints_) edges += static_cast<double>(joint.bound.seam().w.size());
  const double work =
      3 * kIterations * edges * static_cast<double>(4 + problem_.group.elements().size());
  spent_ += work, descents_ += work;
  const double middle = costAt(at);
  if (middle < cost_) cost_ = middle, best_ = at;
  // heeds all seams of the leaders, and may be worse for some
  refine(problem_, edges_, at, active, kIterations);
  const double refined = costAt(at);
  if (refined < cost_) cost_ = refined, best_ = std::move(at);
}

double BoxSearch::bound() const {
  return open_.empty() ? cost_ : std::min(cost_, open_.front().bound);
}

bool BoxSearch::proven() const {
  return cost_ < SearchMoves::kPerfect * edges_.weight() || bound() >= cost_ * (1 - kProven);
}

double BoxSearch::effort() const {
  double sum = 0;
  for (const Boxes& boxes : boxes_)
    sum += boxes.effort(0, kFine * problem_.group.reducedBasis()[0].norm());
  return sum;
}

LowerBound::LowerBound(const MatchProblem& problem, const Component& component,
                       const Alignments& known)
    : edges_(problem, 0), whole_(problem, edges_, component.seams, known) {
  const auto leaders = [&](int seam) {
    return std::minmax({problem.seams[seam].a, problem.seams[seam].b});
  };
  std::vector<int> seams = component.seams;
  std::stable_sort(seams.begin(), seams.end(),
                   [&](int s, int t) { return leaders(s) < leaders(t); });
  for (auto first = seams.begin(); first != seams.end();) {
    const auto last =
        std::find_if(first, seams.end(), [&](int s) { return leaders(s) != leaders(*first); });
    if (first == seams.begin() && last == seams.end()) break;  // the whole
    parts_.emplace_back(problem, edges_, std::vector<int>(first, last), known);
    first = last;
  }
}

bool LowerBound::step() {
  if (proven()) return false;
  BoxSearch* next = &whole_;
  double least = std::numeric_limits<double>::max();
  if (2 * whole_.spent() >= spent()) {
    for (BoxSearch& part : parts_) {
      const double work =
          (1 + part.spent()) * std::pow(kEasierFirst, part.effort()) / (part.cost() - part.bound());
      if (!part.proven() && work < least) least = work, next = &part;
    }
  }
  next->step();
  return !proven();
}

double LowerBound::bound() const {
  double sum = 0;
  for (const BoxSearch& part : parts_) sum += part.bound();
  return std::min(cost(), std::max(whole_.bound(), sum));
}

bool LowerBound::proven() const {
  return whole_.proven() || bound() >= cost() * (1 - BoxSearch::kProven);
}

double LowerBound::spent() const {
  double sum = whole_.spent();
  for (const BoxSearch& part : parts_) sum += part.spent();
  return sum;
}

}  // namespace seamwise
