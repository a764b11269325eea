// Search for a position with little overlap on boards of many dots: some dots are sampled, and
// descents start from the best of them [Gardeyn and Wauters 2025, Algorithms 5 to 7].
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <limits>

#include "marker/layout_search.h"

namespace seamwise {
namespace {

constexpr int kAnywhere = 50, kNear = 25;  ///< numbers of samples: on the whole board, and nearby
constexpr double kNearby = 0.25;           ///< distance of the latter over the piece's size
constexpr std::size_t kDescents = 3;       ///< descents from the best samples
constexpr int kFirstStep = 16, kStep = 2;  ///< first steps in dots: of all descents, and of the
                                           ///< refinement of the best one
constexpr float kNowhere = std::numeric_limits<float>::infinity();

constexpr double kEvaluationReads = 40;  ///< cost of evaluating a dot, in reads; measured
constexpr double kLookupReads = 80;      ///< cost of reading a table there

constexpr std::size_t kLanes = 4, kBox = 4 * kLanes;
using Ints __attribute__((vector_size(16))) = int;
constexpr int kFar = 1 << 30;  ///< coordinate of unused boxes, beyond all dots

Ints intsFrom(const int* numbers) {
  Ints ints;
  std::memcpy(&ints, numbers, sizeof ints);
  return ints;
}

}  // namespace

LayoutSearch::Neighbours LayoutSearch::neighboursOf(int item, int placed) const {
  Neighbours neighbours{othersOf(item, placed, true), {}};
  const std::size_t count = neighbours.others.size();
  neighbours.boxes.assign((count + kLanes - 1) / kLanes * kBox, kFar);
  for (std::size_t k = 0; k < count; ++k) {
    const Other& other = neighbours.others[k];
    const DotRun rows = other.table->rows(), columns = other.table->columns();
    int* box = neighbours.boxes.data() + k / kLanes * kBox + k % kLanes;
    box[0] = other.dot.i + columns.lo;
    box[kLanes] = other.dot.j + rows.lo;
    box[2 * kLanes] = other.dot.i + columns.hi;
    box[3 * kLanes] = other.dot.j + rows.hi;
  }
  return neighbours;
}

/// The weighted sum of overlaps at a dot, or a partial sum of at least `most`.
float LayoutSearch::scoreAt(const Neighbours& neighbours, Dot dot, float most) {
  float sum = 0;
  const Ints i = {dot.i, dot.i, dot.i, dot.i}, j = {dot.j, dot.j, dot.j, dot.j};
  const std::size_t size = neighbours.boxes.size();
  const std::size_t boxes = size / kBox;
  reads_ += kEvaluationReads + 5 * static_cast<double>(boxes);
  for (std::size_t first = 0; first < size && sum < most; first += kBox) {
    const int* box = neighbours.boxes.data() + first;
    const Ints in = (intsFrom(box) <= i) & (intsFrom(box + kLanes) <= j) &
                    (intsFrom(box + 2 * kLanes) >= i) & (intsFrom(box + 3 * kLanes) >= j);
    std::array<long long, 2> halves;
    std::memcpy(halves.data(), &in, sizeof in);
    if ((halves[0] | halves[1]) == 0) continue;
    for (std::size_t k = 0; k < kLanes; ++k) {
      if (in[k] == 0) continue;
      const Other& other = neighbours.others[first / kLanes + k];
      sum += other.weight * static_cast<float>(*other.table->from(dot - other.dot));
      reads_ += kLookupReads;
    }
  }
  return sum;
}

/// Descends along rows, columns and diagonals. Steps are halved down to 2 kStep, or from kStep down
/// to 1.
void LayoutSearch::descend(const Neighbours& neighbours, const Domain& domain, int step,
                           Found* found) {
  constexpr int kAxes = 4;
  constexpr std::array<Dot, kAxes> axes{{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};
  const int last = step > kStep ? 2 * kStep : 1;
  const auto isBetter = [&](const Dot& axis, int by) {
    const Dot dot = found->place.dot + Dot{axis.i * by, axis.j * by};
    if (!domain.has(dot)) return false;
    const float score = scoreAt(neighbours, dot, found->score);
    if (score >= found->score) return false;
    *found = {{found->place.way, dot}, score};
    return true;
  };
  int failures = 0;
  for (int axis = random_.below(kAxes); step >= last && found->score > 0;) {
    if (isBetter(axes[axis], step) || isBetter(axes[axis], -step)) {
      failures = 0;
      continue;
    }
    axis = (axis + 1) % kAxes;
    if (++failures < kAxes) continue;
    step /= 2;
    failures = 0;
  }
}

/// A random dot of a non-empty domain.
Dot LayoutSearch::dotOf(const Domain& domain) {
  const int rows = static_cast<int>(domain.runs.size());
  int row = random_.below(rows);
  while (domain.runs[row].empty()) row = (row + 1) % rows;
  const DotRun& run = domain.runs[row];
  return {run.lo + random_.below(run.size()), domain.first + row};
}

LayoutSearch::Found LayoutSearch::leastOfSome(int item) {
  const LayPlace now = places_[item];
  const std::vector<int>& ways = ways_[item];
  const int count = static_cast<int>(ways.size());
  std::vector<Neighbours> neighbours(ways.size());
  std::array<Found, kDescents + 1> chosen;  // sorted by score
  chosen.fill({{}, kNowhere});
  std::array<int, kDescents + 1> turns{};
  for (int n = 0; n < count; ++n) {
    const int placed = pieces_.items()[item].ways[ways[n]].placed;
    const Domain& domain = domains_[placed];
    if (domain.empty()) continue;
    neighbours[n] = neighboursOf(item, placed);
    const auto look = [&](Dot dot) {
      std::size_t k = kDescents;
      const float score = scoreAt(neighbours[n], dot, chosen[k - 1].score);
      for (; k > 0 && score < chosen[k - 1].score; --k) {
        chosen[k] = chosen[k - 1];
        turns[k] = turns[k - 1];
      }
      chosen[k] = {{ways[n], dot}, score};
      turns[k] = n;
    };
    const Shape& shape = pieces_.shape(placed);
    const Vec2 size = kNearby * (shape.high - shape.low);
    const int across = 1 + static_cast<int>(size.x() / pieces_.board().along.x()),
              up = 1 + static_cast<int>(size.y() / pieces_.board().up.y());
    for (int k = now.way < 0 ? kNear : -1; k < kNear + kAnywhere; k += k < 0 ? 1 : count) {
      Dot dot = now.dot;
      if (k < 0 && now.way != ways[n]) continue;
      if (k >= kNear)
        dot = dotOf(domain);
      else if (k >= 0)
        dot = dot + Dot{random_.below(2 * across + 1) - across, random_.below(2 * up + 1) - up};
      if (domain.has(dot)) look(dot);
    }
  }
  Found best{{}, kNowhere};
  const auto follow = [&](Found found, int n, int step) {
    descend(neighbours[n], domains_[pieces_.items()[item].ways[ways[n]].placed], step, &found);
    return found;
  };
  int turn = 0;
  for (std::size_t k = 0; k < kDescents && chosen[k].place.way >= 0 && best.score > 0; ++k) {
    const Found found = follow(chosen[k], turns[k], kFirstStep);
    if (found.score >= best.score) continue;
    best = found;
    turn = turns[k];
  }
  return best.place.way < 0 ? best : follow(best, turn, kStep);
}

}  // namespace seamwise
