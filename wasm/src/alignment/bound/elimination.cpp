#include "alignment/bound/elimination.h"

#include <algorithm>
#include <limits>

#include "tuning/proof.h"

namespace seamwise {
Elimination::Elimination(const std::vector<double>& sizes,
                         const std::vector<std::pair<int, int>>& joined)
    : alone(sizes.size()), least(sizes.size()), rank_(sizes.size(), -1) {
  const int n = static_cast<int>(sizes.size());
  std::vector<std::vector<char>> near(n, std::vector<char>(n, 0));
  for (const auto& [a, b] : joined) near[a][b] = near[b][a] = 1;
  const auto neighbours = [&](int v) {
    std::vector<int> list;
    for (int u = 0; u < n; ++u)
      if (near[v][u] && rank_[u] < 0) list.push_back(u);
    return list;
  };
  struct Chosen {
    int leader;
    std::vector<int> for_;
  };
  std::vector<Chosen> order;
  for (int k = 0; k < n; ++k) {
    int next = -1;
    double least_fill = std::numeric_limits<double>::max();
    for (int v = 0; v < n; ++v) {
      if (rank_[v] >= 0) continue;
      const std::vector<int> around = neighbours(v);
      double fill = around.size() > 2 ? 1e6 * static_cast<double>(around.size()) : 0;
      for (const int x : around)
        for (const int y : around)
          if (x < y && !near[x][y]) fill += sizes[x] * sizes[y];
      if (fill < least_fill) least_fill = fill, next = v;
    }
    rank_[next] = k;
    std::vector<int> around = neighbours(next);
    bool first = true;
    do {
      Cluster c{next, -1, -1, -1, -1, -1, first, {}};
      first = false;
      if (around.size() > 1) {
        // Prefer two neighbours that already have a table.
        std::size_t p = 0, q = 1;
        for (std::size_t i = 0; i < around.size(); ++i)
          for (std::size_t j = i + 1; j < around.size(); ++j)
            if (near[around[i]][around[j]] && !near[around[p]][around[q]]) p = i, q = j;
        c.x = around[p], c.y = around[q];
        near[c.x][c.y] = near[c.y][c.x] = 1;
        around.erase(around.begin() + static_cast<std::ptrdiff_t>(q));
        around.erase(around.begin() + static_cast<std::ptrdiff_t>(p));
      } else if (!around.empty()) {
        c.x = around[0];
        around.clear();
      }
      clusters_.push_back(c);
    } while (!around.empty());
  }
  for (Cluster& c : clusters_) {
    if (c.y >= 0 && rank_[c.y] < rank_[c.x]) std::swap(c.x, c.y);
    if (c.x >= 0) c.x_table = tableOf(c.x, c.leader);
    if (c.y >= 0) c.y_table = tableOf(c.y, c.leader), c.between = tableOf(c.y, c.x);
  }
}

int Elimination::tableOf(int row, int column) {
  for (std::size_t t = 0; t < tables.size(); ++t)
    if (tables[t].row == row && tables[t].column == column) return static_cast<int>(t);
  tables.push_back({row, column, {}, {}, {}, {}});
  return static_cast<int>(tables.size()) - 1;
}

int Elimination::rowsOf(const Cluster& c) const {
  const int rows = c.y >= 0 ? c.y : c.x;
  return rows < 0 ? 1 : static_cast<int>(alone[rows].size());
}

void Elimination::begin() {
  done_ = 0, row_ = 0, total_ = 0;
  std::size_t most = 0;
  for (std::size_t v = 0; v < alone.size(); ++v) {
    most = std::max(most, alone[v].size());
    least[v].assign(alone[v].size(), kNone);
  }
  for (PairTable& table : tables) table.least.assign(table.to.size(), kNone);
  for (Cluster& c : clusters_)
    c.message.assign(c.y >= 0   ? tables[c.between].to.size()
                     : c.x >= 0 ? alone[c.x].size()
                                : 0,
                     kNone);
  reached_.assign(most, kNone), passed_.assign(most, kNone);
}

bool Elimination::step(double work, double& spent) {
  const double until = spent + work;
  while (done_ < 2 * clusters_.size()) {
    const bool forwards = done_ < clusters_.size();
    Cluster& c = clusters_[forwards ? done_ : 2 * clusters_.size() - 1 - done_];
    for (const int rows = rowsOf(c); row_ < rows; ++row_) {
      if (spent >= until) return true;
      spent += ProofTuning::kSumWork * (forwards ? forward(c, row_) : backward(c, row_));
    }
    ++done_, row_ = 0;
  }
  return false;
}

/// Passes the least cost of the leader to a row of its neighbours. Returns the number of sums.
double Elimination::forward(Cluster& c, int row) {
  const std::vector<float>& own = alone[c.leader];
  if (c.x < 0) {
    total_ += static_cast<double>(*std::min_element(own.begin(), own.end()));
    return static_cast<double>(own.size());
  }
  const PairTable& of_x = tables[c.x_table];
  if (c.y < 0) {
    float best = kNone;
    for (int e = of_x.begin[row]; e < of_x.begin[row + 1]; ++e)
      best = std::min(best, c.alone ? of_x.cost[e] + own[of_x.to[e]] : of_x.cost[e]);
    c.message[row] = best;
    alone[c.x][row] += best;
    return of_x.begin[row + 1] - of_x.begin[row];
  }
  const PairTable& of_y = tables[c.y_table];
  PairTable& between = tables[c.between];
  double sums = 0;
  for (int e = of_y.begin[row]; e < of_y.begin[row + 1]; ++e)
    reached_[of_y.to[e]] = of_y.cost[e] + (c.alone ? own[of_y.to[e]] : 0);
  for (int e = between.begin[row]; e < between.begin[row + 1]; ++e) {
    const int first = of_x.begin[between.to[e]], last = of_x.begin[between.to[e] + 1];
    float best = kNone;
    for (int f = first; f < last; ++f) best = std::min(best, of_x.cost[f] + reached_[of_x.to[f]]);
    c.message[e] = best;
    between.cost[e] += best;
    sums += last - first;
  }
  for (int e = of_y.begin[row]; e < of_y.begin[row + 1]; ++e) reached_[of_y.to[e]] = kNone;
  return sums;
}

/// Passes the cost of everything else from a row of its neighbours to the leader. Returns the
/// number of sums.
double Elimination::backward(Cluster& c, int row) {
  const std::vector<float>& own = alone[c.leader];
  std::vector<float>& mine = least[c.leader];
  if (c.x < 0) {
    const double own_least = static_cast<double>(*std::min_element(own.begin(), own.end()));
    const float others = static_cast<float>(total_ - own_least);
    for (std::size_t i = 0; i < own.size(); ++i) mine[i] = own[i] + others;
    return static_cast<double>(own.size());
  }
  PairTable& of_x = tables[c.x_table];
  if (c.y < 0) {
    if (c.message[row] >= kNone) return 1;
    const float others = least[c.x][row] - c.message[row];
    for (int e = of_x.begin[row]; e < of_x.begin[row + 1]; ++e) {
      const float sum = others + of_x.cost[e] + (c.alone ? own[of_x.to[e]] : 0);
      of_x.least[e] = sum;
      if (c.alone) mine[of_x.to[e]] = std::min(mine[of_x.to[e]], sum);
    }
    return of_x.begin[row + 1] - of_x.begin[row];
  }
  PairTable& of_y = tables[c.y_table];
  const PairTable& between = tables[c.between];
  double sums = 0;
  for (int e = of_y.begin[row]; e < of_y.begin[row + 1]; ++e)
    reached_[of_y.to[e]] = of_y.cost[e] + (c.alone ? own[of_y.to[e]] : 0);
  for (int e = between.begin[row]; e < between.begin[row + 1]; ++e) {
    if (c.message[e] >= kNone || between.least[e] >= kNone) continue;
    const float others = between.least[e] - c.message[e];
    const int first = of_x.begin[between.to[e]], last = of_x.begin[between.to[e] + 1];
    for (int f = first; f < last; ++f) {
      const int i = of_x.to[f];
      const float sum = others + of_x.cost[f] + reached_[i];
      of_x.least[f] = std::min(of_x.least[f], sum);
      passed_[i] = std::min(passed_[i], sum);
    }
    sums += last - first;
  }
  for (int e = of_y.begin[row]; e < of_y.begin[row + 1]; ++e) {
    const int i = of_y.to[e];
    of_y.least[e] = passed_[i];
    if (c.alone) mine[i] = std::min(mine[i], passed_[i]);
    reached_[i] = passed_[i] = kNone;
  }
  return sums;
}

}  // namespace seamwise
