#include "pattern/sampling.h"

#include <algorithm>
#include <cmath>

#include "base/decimal.h"
#include "geometry/polygon.h"

namespace seamwise {
namespace {

constexpr double kChordTurn = kPi / 10;
constexpr double kShortestChord = 0.02;  // cm; ends refinement at a cusp, which is a corner
constexpr int kRefinements = 40;

/// A stretch of one edge between neighbouring breakpoints.
struct Interval {
  const Curve* curve = nullptr;
  double from = 0, to = 0;  // fractions of the curve's length
  double length() const { return (to - from) * curve->length(); }
  double fraction(int k, int count) const { return from + (to - from) * k / count; }
};

bool bendsTooMuch(const Interval& i, int count) {
  for (int k = 0; k < count; ++k)
    if (i.curve->turning(i.fraction(k, count), i.fraction(k + 1, count)) > 1.25 * kChordTurn)
      return true;
  return false;
}

/// Number of chords for an interval, apart from its ties.
int countFor(const Interval& i, double edge_length) {
  const int straight = std::max(1, static_cast<int>(std::ceil(i.length() / edge_length - 1e-9)));
  if (i.curve->straight()) return straight;
  const int finest = std::max(straight, static_cast<int>(i.length() / kShortestChord));
  const double turning = i.curve->turning(i.from, i.to);
  int count = std::max(straight, static_cast<int>(std::ceil(turning / kChordTurn - 1e-9)));
  // A bend in one spot needs a finer even spacing. If twice the count is not enough, the spot is
  // treated as a corner.
  const int most = std::min(finest, 2 * count);
  count = std::min(count, finest);
  while (count < most && bendsTooMuch(i, count)) count = std::min(most, count + 1 + count / 4);
  return count;
}

class Sampler {
 public:
  Sampler(const Outlines& outlines, const Breakpoints& breakpoints, double edge_length)
      : outlines_(outlines), breakpoints_(breakpoints), count_(breakpoints.group.size(), 1) {
    for (std::size_t l = 0; l < outlines.loops.size(); ++l) {
      const Loop& loop = outlines.loops[l].loop;
      const auto& nodes = breakpoints.nodes[l];
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        const int k = loop.edgeAt(nodes[i]);
        const double length = loop.edge(k).length();
        const double end = i + 1 < nodes.size() ? nodes[i + 1] : loop.length();
        const double to = end >= loop.corner(k + 1) ? 1 : (end - loop.corner(k)) / length;
        intervals_.push_back({&loop.edge(k), (nodes[i] - loop.corner(k)) / length, to});
      }
    }
    for (std::size_t i = 0; i < intervals_.size(); ++i) {
      int& count = count_[breakpoints.group[i]];
      count = std::max(count, countFor(intervals_[i], edge_length));
    }
    for (std::size_t l = 0; l < outlines.loops.size(); ++l) giveArea(static_cast<int>(l));
  }

  Outcome<std::vector<SampledLoop>> sample() {
    const int panels = static_cast<int>(outlines_.first.size());
    for (int round = 0;; ++round) {
      sampled_.clear();
      for (std::size_t l = 0; l < outlines_.loops.size(); ++l)
        sampled_.push_back(sampleLoop(static_cast<int>(l)));
      bool refined = false;
      for (int p = 0; p < panels; ++p) {
        const auto crossing = crossingOf(p);
        if (!crossing) continue;
        if (round == kRefinements || !refine(p, *crossing))
          return Error{Failure::kMesh,
                       "the outline crosses or touches itself near (" + shown(crossing->at.x()) +
                           ", " + shown(crossing->at.y()) + ") cm; redraw it there",
                       p};
        refined = true;
      }
      if (!refined) return sampled_;
    }
  }

 private:
  static std::string shown(double value) { return fixed(std::round(value * 10) / 10, 1); }

  int loopEnd(int panel) const {
    return panel + 1 < static_cast<int>(outlines_.first.size())
               ? outlines_.first[panel + 1]
               : static_cast<int>(outlines_.loops.size());
  }

  int& count(int l, std::size_t interval) {
    return count_[breakpoints_.group[breakpoints_.first_interval[l] + interval]];
  }

  /// Gives a loop of one or two edges at least three vertices.
  void giveArea(int l) {
    const std::size_t n = breakpoints_.nodes[l].size();
    const auto total = [&] {
      int sum = 0;
      for (std::size_t i = 0; i < n; ++i) sum += count(l, i);
      return sum;
    };
    while (total() < 3) {
      // Splitting a straight interval adds no area, so split a curved one, the longest first.
      std::size_t best = 0;
      const auto rank = [&](std::size_t i) {
        const Interval& it = intervals_[breakpoints_.first_interval[l] + i];
        return std::pair{!it.curve->straight(), it.length() / count(l, i)};
      };
      for (std::size_t i = 1; i < n; ++i)
        if (rank(i) > rank(best)) best = i;
      ++count(l, best);
    }
  }

  SampledLoop sampleLoop(int l) {
    SampledLoop out;
    const Loop& loop = outlines_.loops[l].loop;
    const auto& nodes = breakpoints_.nodes[l];
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      out.node_vertex.push_back(static_cast<int>(out.points.size()));
      const Interval& it = intervals_[breakpoints_.first_interval[l] + i];
      const int n = count(l, i);
      for (int k = 0; k < n; ++k) out.points.push_back(it.curve->atFraction(it.fraction(k, n)));
    }
    for (int k = 0; k < loop.edges(); ++k)
      out.edge_start.push_back(out.node_vertex[breakpoints_.nodeAt(l, loop.corner(k))]);
    return out;
  }

  std::optional<Crossing> crossingOf(int panel) const {
    std::vector<Polyline> loops;
    for (int l = outlines_.first[panel]; l < loopEnd(panel); ++l)
      loops.push_back(sampled_[l].points);
    return findCrossing(loops);
  }

  /// A chord that crosses another one, and its distance from its curve. [cm]
  struct Offender {
    int loop;
    std::size_t interval;
    double bulge;
  };

  Offender offender(int l, int edge) {
    const auto& starts = sampled_[l].node_vertex;
    const auto after = std::upper_bound(starts.begin(), starts.end(), edge);
    const std::size_t i = after - starts.begin() - 1;
    const Interval& it = intervals_[breakpoints_.first_interval[l] + i];
    const int n = count(l, i), k = edge - starts[i];
    if (it.curve->straight() || it.length() / n < kShortestChord) return {l, i, 0};
    const auto at = [&](int half) { return it.curve->atFraction(it.fraction(half, 2 * n)); };
    return {l, i, ((at(2 * k) + at(2 * k + 2)) / 2 - at(2 * k + 1)).norm()};
  }

  /// Refines the chord that is further from its curve. Refining both equally would never end for
  /// arcs that meet without an angle. Returns false if both are straight or short.
  bool refine(int panel, const Crossing& crossing) {
    const int base = outlines_.first[panel];
    const Offender a = offender(base + crossing.first_loop, crossing.first_edge);
    const Offender b = offender(base + crossing.second_loop, crossing.second_edge);
    const Offender& worse = a.bulge >= b.bulge ? a : b;
    if (worse.bulge == 0) return false;
    int& n = count(worse.loop, worse.interval);
    n += (n + 1) / 2;
    return true;
  }

  const Outlines& outlines_;
  const Breakpoints& breakpoints_;
  std::vector<Interval> intervals_;
  std::vector<int> count_;  // per group, at the index of its least interval
  std::vector<SampledLoop> sampled_;
};

}  // namespace

Outcome<std::vector<SampledLoop>> sampleLoops(const Outlines& outlines,
                                              const Breakpoints& breakpoints, double edge_length) {
  return Sampler(outlines, breakpoints, edge_length).sample();
}

}  // namespace seamwise
