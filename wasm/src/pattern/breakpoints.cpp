#include "pattern/breakpoints.h"

#include <algorithm>
#include <cmath>

#include "base/disjoint_sets.h"
#include "pattern/ties.h"

namespace seamwise {
int Breakpoints::nodeAt(int loop, double position) const {
  const auto& all = nodes[loop];
  return static_cast<int>(std::lower_bound(all.begin(), all.end(), position) - all.begin());
}

Breakpoints findBreakpoints(const Outlines& outlines, double tolerance, std::size_t most,
                            bool settled) {
  Breakpoints result;
  TiedNodes tied(outlines);
  if (!tied.close(tolerance, most)) {
    result.conflict = "seams and symmetries demand ever more vertices of its outline";
    result.conflicting_panel = outlines.loops[tied.nodes().back().loop].panel;
    return result;
  }

  std::vector<int> rank(tied.nodes().size());
  int count = 0;
  for (std::size_t l = 0; l < outlines.loops.size(); ++l) {
    result.nodes.emplace_back();
    result.first_interval.push_back(count);
    const std::vector<int>& order = tied.order(static_cast<int>(l));
    for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = static_cast<int>(i);
    result.nodes.back().resize(order.size());
    count += static_cast<int>(order.size());
  }
  DisjointSets groups(count);
  for (const Tie& tie : tied.ties()) {
    const Tie::Side &a = tie.side[0], &b = tie.side[1];
    const int n = static_cast<int>(result.nodes[a.loop].size());
    const int m = static_cast<int>(result.nodes[b.loop].size());
    const auto parts = [&](const Tie::Side& s, int size) {
      const int steps = static_cast<int>(s.sense) * (rank[s.last] - rank[s.first]);
      return s.first == s.last ? size : (steps % size + size) % size;
    };
    if (parts(a, n) != parts(b, m)) {
      result.conflict = "its outline cannot be cut into parts that match along seams and mirrors";
      result.conflicting_panel = outlines.loops[a.loop].panel;
      return result;
    }
    // The k-th interval of a side starts at its k-th node, or ends there if the side runs
    // backwards.
    const auto interval = [&](const Tie::Side& s, int size, int k) {
      const int at = s.sense > 0 ? rank[s.first] + k : rank[s.first] - k - 1;
      return result.first_interval[s.loop] + ((at % size) + size) % size;
    };
    for (int k = 0; k < parts(a, n); ++k) groups.join(interval(a, n, k), interval(b, m, k));
    if (tie.mirror) result.image_of_first.push_back(((rank[a.first] + rank[b.first]) % n + n) % n);
  }
  for (int i = 0; i < count; ++i) result.group.push_back(groups.find(i));
  if (settled) tied.settle();
  for (std::size_t l = 0; l < result.nodes.size(); ++l)
    for (std::size_t i = 0; i < result.nodes[l].size(); ++i)
      result.nodes[l][i] = tied.nodes()[tied.order(static_cast<int>(l))[i]].position;
  return result;
}

}  // namespace seamwise
