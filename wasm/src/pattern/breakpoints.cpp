#include "pattern/breakpoints.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>

namespace seamwise {
namespace {

/// A sewn edge and where its partner's sewing order leads.
struct Partner {
  int loop = -1, edge = -1;
  bool same_direction = false;
};

/// Grows the set of breakpoints; tie() then pairs up what lies between them.
class Builder {
 public:
  Builder(const Outlines& outlines, double tolerance)
      : outlines_(outlines), partner_(outlines.loops.size()), slack_(outlines.loops.size()) {
    result_.nodes.resize(outlines.loops.size());
    for (std::size_t l = 0; l < outlines.loops.size(); ++l) {
      const Loop& loop = outlines.loops[l].loop;
      partner_[l].resize(loop.edges());
      for (int k = 0; k < loop.edges(); ++k)
        slack_[l].push_back(std::min(tolerance, loop.edge(k).length() / 4));
    }
    for (const Stitch& s : outlines.stitches) {
      const int a = outlines.first[s.a.piece], b = outlines.first[s.b.piece];
      partner_[a][s.a.edge] = {b, s.b.edge, s.same_direction};
      partner_[b][s.b.edge] = {a, s.a.edge, s.same_direction};
      // The same fraction on both sides, so that what is one here is one there.
      const double length_a = outlines.loops[a].loop.edge(s.a.edge).length();
      const double length_b = outlines.loops[b].loop.edge(s.b.edge).length();
      const double fraction = std::min(tolerance / std::max(length_a, length_b), 0.25);
      slack_[a][s.a.edge] = fraction * length_a;
      slack_[b][s.b.edge] = fraction * length_b;
    }
  }

  Breakpoints build() {
    std::size_t limit = 64;
    for (std::size_t l = 0; l < outlines_.loops.size(); ++l) {
      const Loop& loop = outlines_.loops[l].loop;
      limit += 16 * static_cast<std::size_t>(loop.edges());
      for (int k = 0; k < loop.edges(); ++k) {
        result_.nodes[l].push_back(loop.corner(k));
        open_.push_back({static_cast<int>(l), loop.corner(k)});
      }
    }
    for (const LoopTie& tie : outlines_.ties) {
      for (const Correspondence::Anchor& a : tie.map.anchors) {
        add(tie.from, a.from);
        add(tie.to, a.to);
      }
    }
    for (std::size_t count = 0; !open_.empty(); ++count) {
      if (count > limit) {
        blame(open_.front().loop, "seams and symmetries demand ever more vertices of it");
        return result_;
      }
      const Place place = open_.front();
      open_.pop_front();
      carry(place);
    }
    tie();
    return result_;
  }

 private:
  struct Place {
    int loop;
    double position;
  };

  void blame(int loop, const std::string& why) {
    if (!result_.trouble.empty()) return;
    result_.trouble = why;
    result_.troubled_panel = outlines_.loops[loop].panel;
  }

  void add(int l, double position) {
    const Loop& loop = outlines_.loops[l].loop;
    auto& nodes = result_.nodes[l];
    const double p = loop.wrapped(position), slack = slack_[l][loop.edgeAt(p)];
    const auto next = std::lower_bound(nodes.begin(), nodes.end(), p);
    const double after = next != nodes.end() ? *next : loop.length();
    const double before = next != nodes.begin() ? *(next - 1) : nodes.back() - loop.length();
    if (after - p <= slack || p - before <= slack) return;
    nodes.insert(next, p);
    open_.push_back({l, p});
  }

  void carry(const Place& place) {
    const Loop& loop = outlines_.loops[place.loop].loop;
    const int k = loop.edgeAt(place.position);
    const Partner& partner = partner_[place.loop][k];
    if (partner.loop >= 0 && place.position > loop.corner(k)) {
      const double s = (place.position - loop.corner(k)) / loop.edge(k).length();
      const Loop& other = outlines_.loops[partner.loop].loop;
      add(partner.loop, other.corner(partner.edge) + other.edge(partner.edge).length() *
                                                         (partner.same_direction ? s : 1 - s));
    }
    for (const LoopTie& tie : outlines_.ties) {
      if (tie.from == place.loop) add(tie.to, tie.map.image(place.position));
      if (tie.to == place.loop) add(tie.from, tie.map.preimage(place.position));
    }
  }

  int nodeCount(int l) const { return static_cast<int>(result_.nodes[l].size()); }

  int find(int interval) {
    while (result_.group[interval] != interval)
      interval = result_.group[interval] = result_.group[result_.group[interval]];
    return interval;
  }
  void unite(int a, int b) {
    a = find(a), b = find(b);
    result_.group[std::max(a, b)] = std::min(a, b);
  }

  void tie() {
    int count = 0;
    for (std::size_t l = 0; l < result_.nodes.size(); ++l) {
      result_.first_interval.push_back(count);
      count += nodeCount(static_cast<int>(l));
    }
    result_.group.resize(count);
    std::iota(result_.group.begin(), result_.group.end(), 0);
    for (const Stitch& s : outlines_.stitches) tieSeam(s);
    for (const LoopTie& t : outlines_.ties) tieMirror(t);
    for (int i = 0; i < count; ++i) find(i);
    for (int i = 0; i < count; ++i) result_.group[i] = find(i);
  }

  /// Numbers of the first interval of an edge and of the first one after it.
  std::pair<int, int> intervalsOf(int l, int edge) const {
    const Loop& loop = outlines_.loops[l].loop;
    const int first = result_.first_interval[l];
    const int from = result_.nodeAt(l, loop.corner(edge));
    const int to =
        edge + 1 < loop.edges() ? result_.nodeAt(l, loop.corner(edge + 1)) : nodeCount(l);
    return {first + from, first + to};
  }

  void tieSeam(const Stitch& s) {
    const int a = outlines_.first[s.a.piece], b = outlines_.first[s.b.piece];
    const auto [a0, a1] = intervalsOf(a, s.a.edge);
    const auto [b0, b1] = intervalsOf(b, s.b.edge);
    if (a1 - a0 != b1 - b0) {
      blame(a, "the two sides of one of its seams cannot be cut into matching parts");
      return;
    }
    for (int k = 0; k < a1 - a0; ++k) unite(a0 + k, s.same_direction ? b0 + k : b1 - 1 - k);
  }

  void tieMirror(const LoopTie& t) {
    const auto &from = result_.nodes[t.from], &to = result_.nodes[t.to];
    const Loop& loop = outlines_.loops[t.to].loop;
    const int n = nodeCount(t.from);
    result_.image_of_first.push_back(0);
    if (n != nodeCount(t.to)) {
      blame(t.from, "its outline cannot be matched point by point with its mirror image");
      return;
    }
    const auto gap = [&](int i, int j) {
      const double d = std::abs(loop.wrapped(t.map.image(from[i])) - to[j]);
      return std::min(d, loop.length() - d);
    };
    int first = 0;
    for (int j = 1; j < n; ++j)
      if (gap(0, j) < gap(0, first)) first = j;
    result_.image_of_first.back() = first;
    const int f = result_.first_interval[t.from], g = result_.first_interval[t.to];
    for (int i = 0; i < n; ++i) {
      const int j = ((first - i) % n + n) % n;
      const double slack = std::max(slack_[t.to][loop.edgeAt(to[j])],
                                    slack_[t.to][loop.edgeAt(to[(j + n - 1) % n])]);
      if (gap(i, j) > 2 * slack + 1e-6) {
        blame(t.from, "its outline cannot be matched point by point with its mirror image");
        return;
      }
      unite(f + i, g + (j + n - 1) % n);
    }
  }

  const Outlines& outlines_;
  std::vector<std::vector<Partner>> partner_;  // per loop and edge
  std::vector<std::vector<double>> slack_;  // per loop and edge: closer breakpoints are one. [cm]
  std::deque<Place> open_;
  Breakpoints result_;
};

}  // namespace

int Breakpoints::nodeAt(int loop, double position) const {
  const auto& all = nodes[loop];
  return static_cast<int>(std::lower_bound(all.begin(), all.end(), position) - all.begin());
}

Breakpoints findBreakpoints(const Outlines& outlines, double tolerance) {
  return Builder(outlines, tolerance).build();
}

}  // namespace seamwise
