#include "pattern/ties.h"

#include <algorithm>
#include <cmath>

namespace seamwise {
namespace {

constexpr double kSamePlace = 1e-9;      // cm
constexpr double kApart = 1e-3;          // cm; distance that different nodes keep if possible
constexpr double kPlacesSettled = 1e-6;  // cm
constexpr double kWithin = 0.25;  // cm; corners within paths match in spite of this much ease
constexpr int kMostSweeps = 150;  // contradictory symmetries would move nodes without end

}  // namespace

TiedNodes::TiedNodes(const Outlines& outlines)
    : outlines_(&outlines), order_(outlines.loops.size()), ties_of_(outlines.loops.size()) {
  for (int l = 0; l < static_cast<int>(outlines.loops.size()); ++l) {
    const Loop& loop = loopOf(l);
    for (const double p : loop.corners())
      nodes_[add(l, p, true)].within = p != loop.corner(loop.edgeAt(p));
  }
  for (const Stitch& s : outlines.stitches) addSeam(s);
  for (const LoopTie& t : outlines.ties) addMirror(t);
  for (std::size_t t = 0; t < ties_.size(); ++t)
    for (const int side : {0, 1})
      if (!ties_[t].self || side == 0)
        ties_of_[ties_[t].side[side].loop].emplace_back(static_cast<int>(t), side);
}

int TiedNodes::add(int loop, double position, bool pinned) {
  auto& order = order_[loop];
  const double p = loopOf(loop).wrapped(position);
  const auto next = order.begin() + static_cast<std::ptrdiff_t>(indexAt(loop, p));
  for (const auto at : {next, next == order.begin() ? order.end() : next - 1})
    if (at != order.end() && std::abs(nodes_[*at].position - p) <= kSamePlace) {
      nodes_[*at].pinned = nodes_[*at].pinned || pinned;
      return *at;
    }
  if (!order.empty() && loopOf(loop).length() - p <= kSamePlace) return order.front();
  const int node = static_cast<int>(nodes_.size());
  nodes_.push_back({loop, p, pinned, false});
  order.insert(next, node);
  open_.push_back(node);
  return node;
}

double TiedNodes::coordinate(const Tie::Side& side, int node) const {
  return loopOf(side.loop).wrapped(side.sense * (nodes_[node].position - side.origin));
}

bool TiedNodes::holds(const Tie::Side& side, int node) const {
  if (nodes_[node].loop != side.loop || node == side.first || node == side.last) return false;
  return coordinate(side, node) < side.length;
}

int TiedNodes::counterpart(const Tie& tie, int side, int node) const {
  const auto found = tie.counterpart[tie.self ? 0 : side].find(node);
  return found == tie.counterpart[tie.self ? 0 : side].end() ? -1 : found->second;
}

void TiedNodes::match(Tie& tie, int side, int node, int other) {
  tie.counterpart[tie.self ? 0 : side][node] = other;
  tie.counterpart[tie.self ? 0 : 1 - side][other] = node;
}

void TiedNodes::addSeam(const Stitch& s) {
  Tie tie;
  const EdgeRef refs[2] = {s.a, s.b};
  for (const int k : {0, 1}) {
    const int l = outlines_->first[refs[k].piece], e = refs[k].edge;
    const bool ahead = k == 0 || s.same_direction;
    const int start = add(l, loopOf(l).corner(e), true),
              end = add(l, loopOf(l).corner(e + 1), true);
    tie.side[k] = {l,
                   nodes_[ahead ? start : end].position,
                   ahead ? 1.0 : -1.0,
                   loopOf(l).edge(e).length(),
                   ahead ? start : end,
                   ahead ? end : start};
  }
  ties_.push_back(std::move(tie));
}

void TiedNodes::addMirror(const LoopTie& mirror) {
  Tie tie;
  tie.mirror = true;
  tie.self = mirror.from == mirror.to;
  const auto& anchors = mirror.map.anchors;
  // Both ends are the first pair of anchors; the sides run in opposite senses.
  const int a = add(mirror.from, anchors.front().from, tie.self);
  const int b = add(mirror.to, anchors.front().to, tie.self);
  tie.side[0] = {mirror.from, nodes_[a].position, 1, loopOf(mirror.from).length(), a, a};
  tie.side[1] = {mirror.to, nodes_[b].position, -1, loopOf(mirror.to).length(), b, b};
  match(tie, 0, a, b);
  ties_.push_back(std::move(tie));
}

/// Index in a loop's order of the first node at or after a position.
std::size_t TiedNodes::indexAt(int loop, double position) const {
  const auto& order = order_[loop];
  const auto found =
      std::lower_bound(order.begin(), order.end(), position,
                       [&](int node, double value) { return nodes_[node].position < value; });
  return static_cast<std::size_t>(found - order.begin());
}

TiedNodes::Bracket TiedNodes::bracketOf(const Tie& tie, int side, int node) const {
  const Tie::Side &own = tie.side[side], &other = tie.side[1 - side];
  const auto& order = order_[own.loop];
  const std::size_t n = order.size(), start = indexAt(own.loop, nodes_[node].position);
  const double at = coordinate(own, node);
  Bracket b{at, 0, own.length, 0, other.length};
  // Search in both directions for the first matched node.
  for (const bool up : {false, true}) {
    const std::size_t step = up == (own.sense > 0) ? 1 : n - 1;
    for (std::size_t k = 1, i = start; k < n; ++k) {
      i = (i + step) % n;
      const double x = coordinate(own, order[i]);
      if (up ? x <= at || x >= b.high : x >= at || x <= b.low) break;
      if (!holds(own, order[i])) continue;
      const int match = counterpart(tie, side, order[i]);
      if (match < 0) continue;
      (up ? b.high : b.low) = x;
      (up ? b.other_high : b.other_low) = coordinate(other, match);
      break;
    }
  }
  return b;
}

/// The node of a tie's side, between the bracket's ends, nearest to a coordinate and at most
/// `reach` away; -1 if there is none.
int TiedNodes::nearestTo(const Tie::Side& side, double x, double reach, const Bracket& b) const {
  const auto& order = order_[side.loop];
  const std::size_t n = order.size();
  const std::size_t start =
      indexAt(side.loop, loopOf(side.loop).wrapped(side.origin + side.sense * x));
  int found = -1;
  std::size_t found_at = 0;
  double nearest = reach;
  for (const bool ahead : {true, false}) {
    std::size_t i = ahead ? start % n : (start + n - 1) % n;
    for (std::size_t k = 0; k < n; ++k, i = (i + (ahead ? 1 : n - 1)) % n) {
      const double y = coordinate(side, order[i]), gap = std::abs(y - x);
      if (gap > nearest) break;
      if (y <= b.other_low || y >= b.other_high || !holds(side, order[i])) continue;
      if (found >= 0 && gap == nearest && i < found_at) continue;  // prefer the later node
      nearest = gap;
      found = order[i];
      found_at = i;
    }
  }
  return found;
}

void TiedNodes::place(Tie& tie, int side, int node, double tolerance, const double* wanted) {
  const Tie::Side &own = tie.side[side], &other = tie.side[1 - side];
  const Bracket b = bracketOf(tie, side, node);
  const double gap = b.other_high - b.other_low, margin = std::min(0.05 * gap, kApart);
  double x = b.other_low + gap * (b.at - b.low) / (b.high - b.low);
  if (wanted) x = loopOf(other.loop).wrapped(other.sense * (*wanted - other.origin));
  x = std::clamp(x, b.other_low + margin, b.other_high - margin);
  // The tolerance is the same fraction of a seam on both sides, so that both identify the same
  // nodes.
  const double reach =
      tolerance * (tie.mirror ? 1 : other.length / std::max(own.length, other.length));
  int found = nearestTo(other, x, reach, b);
  if (found < 0) {
    const int near = nearestTo(other, x, kWithin, b);
    if (near >= 0 && (nodes_[node].within || nodes_[near].within)) found = near;
  }
  if (found < 0) found = add(other.loop, other.origin + other.sense * x, false);
  match(tie, side, node, found);
}

void TiedNodes::anchor(Tie& tie, const Correspondence& map, double tolerance) {
  const int a = tie.side[0].loop, b = tie.side[1].loop;
  const auto same = [&](const Correspondence::Anchor& x) {
    return tie.self && std::abs(std::remainder(x.from - x.to, loopOf(a).length())) <= kSamePlace;
  };
  for (const Correspondence::Anchor& x : map.anchors) {
    if (!x.certain) continue;
    const int node = add(a, x.from, same(x));
    if (counterpart(tie, 0, node) < 0) match(tie, 0, node, same(x) ? node : add(b, x.to, false));
  }
  // Place the corners without a partner between those.
  for (const Correspondence::Anchor& x : map.anchors) {
    if (x.certain) continue;
    const bool corner = loopOf(a).isCorner(x.from);
    const int side = corner ? 0 : 1;
    const int node = corner ? add(a, x.from, true) : add(b, x.to, true);
    const double wanted = corner ? x.to : x.from;
    if (counterpart(tie, side, node) < 0) place(tie, side, node, tolerance, &wanted);
  }
}

bool TiedNodes::close(double tolerance, std::size_t most) {
  for (std::size_t t = 0; t < outlines_->ties.size(); ++t)
    anchor(ties_[outlines_->stitches.size() + t], outlines_->ties[t].map, tolerance);
  while (!open_.empty()) {
    if (nodes_.size() > most) return false;
    const int node = open_.front();
    open_.pop_front();
    for (const auto& [t, side] : ties_of_[nodes_[node].loop])
      if (holds(ties_[t].side[side], node) && counterpart(ties_[t], side, node) < 0)
        place(ties_[t], side, node, tolerance, nullptr);
  }
  return true;
}

TiedNodes::Demand TiedNodes::demandOf(const Tie& tie, int side, int before, int node,
                                      int after) const {
  const Tie::Side &own = tie.side[side], &other = tie.side[1 - side];
  const bool ahead = own.sense > 0;
  // Along the loop, `before` can only be the low end of a side that runs ahead, or the high end of
  // one that runs back; `after` vice versa.
  const auto image = [&](int n, bool low) {
    if (low && n == own.first) return other.first;
    if (!low && n == own.last) return other.last;
    return counterpart(tie, side, n);
  };
  return {image(before, ahead), image(node, ahead), image(after, !ahead), own.sense * other.sense,
          &loopOf(other.loop)};
}

void TiedNodes::settle() {
  struct Free {
    int before, node, after;
    const Loop* loop;
    std::vector<Demand> demands;
  };
  std::vector<Free> free;
  for (std::size_t l = 0; l < order_.size(); ++l) {
    const auto& order = order_[l];
    for (std::size_t i = 1; i < order.size(); ++i) {  // node 0 is a corner
      if (nodes_[order[i]].pinned) continue;
      const Loop& own = loopOf(static_cast<int>(l));
      Free f{order[i - 1], order[i], order[(i + 1) % order.size()], &own, {}};
      for (const auto& [t, side] : ties_of_[l])
        if (holds(ties_[t].side[side], f.node))
          f.demands.push_back(demandOf(ties_[t], side, f.before, f.node, f.after));
      if (!f.demands.empty()) free.push_back(std::move(f));
    }
  }
  const auto distance = [&](const Loop& loop, int from, int to, double sense) {
    return loop.wrapped(sense * (nodes_[to].position - nodes_[from].position));
  };
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    double moved = 0;
    for (const Free& f : free) {
      double sum = 0;
      for (const Demand& w : f.demands) {
        const double part = distance(*w.loop, w.before, w.at, w.sense);
        const double whole = part + distance(*w.loop, w.at, w.after, w.sense);
        sum += whole > 0 ? part / whole : 0.5;  // coincident neighbours define no proportion
      }
      const double share = sum / static_cast<double>(f.demands.size());
      const double position =
          nodes_[f.before].position + share * distance(*f.loop, f.before, f.after, 1);
      moved = std::max(moved, std::abs(position - nodes_[f.node].position));
      nodes_[f.node].position = position;
    }
    if (moved < kPlacesSettled) return;
  }
}

}  // namespace seamwise
