#include <algorithm>

#include "alignment/bound/box_tables.h"

namespace seamwise {

void BoxTables::drop(float cost) {
  const int n = leaders();
  auto& tables = elimination_.tables;
  std::vector<std::vector<char>> stays(n);
  for (int v = 0; v < n; ++v) {
    stays[v].resize(covers_[v].all.size());
    for (std::size_t i = 0; i < stays[v].size(); ++i) stays[v][i] = elimination_.least[v][i] < cost;
  }
  const auto left = [&](const PairTable& table, int r, int e) {
    return table.least[e] < cost && stays[table.row][r] && stays[table.column][table.to[e]];
  };
  // Boxes without a partner are dropped as well, with all their pairs.
  for (bool again = true; again;) {
    again = false;
    for (const PairTable& table : tables) {
      std::vector<char> row(stays[table.row].size(), 0), column(stays[table.column].size(), 0);
      for (std::size_t r = 0; r < row.size(); ++r)
        for (int e = table.begin[r]; e < table.begin[r + 1]; ++e)
          if (left(table, static_cast<int>(r), e)) row[r] = column[table.to[e]] = 1;
      const auto keep = [&](std::vector<char>& kept, const std::vector<char>& met) {
        for (std::size_t i = 0; i < kept.size(); ++i)
          if (kept[i] && !met[i]) kept[i] = 0, again = true;
      };
      keep(stays[table.row], row), keep(stays[table.column], column);
    }
  }
  std::vector<std::vector<int>> moved(n);
  for (std::size_t t = 0; t < tables.size(); ++t) {
    PairTable& table = tables[t];
    const int stride = joints_[t].stride;
    std::vector<float>& terms = joints_[t].terms;
    std::vector<int> place(stays[table.column].size(), 0);
    for (std::size_t i = 1; i < place.size(); ++i)
      place[i] = place[i - 1] + stays[table.column][i - 1];
    int to = 0, rows = 0, from = 0;
    for (std::size_t r = 0; r + 1 < table.begin.size(); ++r) {
      const int end = table.begin[r + 1];
      for (int e = from; e < end; ++e) {
        if (!left(table, static_cast<int>(r), e)) continue;
        table.to[to] = place[table.to[e]], table.least[to] = table.least[e];
        if (stride > 0) joints_[t].stale[to] = joints_[t].stale[e];
        std::copy_n(terms.begin() + static_cast<std::ptrdiff_t>(e) * stride, stride,
                    terms.begin() + static_cast<std::ptrdiff_t>(to) * stride);
        ++to;
      }
      from = end;
      if (stays[table.row][r]) table.begin[++rows] = to;
    }
    table.begin.resize(rows + 1), table.to.resize(to), table.least.resize(to),
        terms.resize(static_cast<std::size_t>(to) * stride);
    if (stride > 0) joints_[t].stale.resize(to);
  }
  for (int v = 0; v < n; ++v) {
    Cover& cover = covers_[v];
    const std::size_t stride = cover.stride(), width = cover.tilted();
    std::size_t to = 0;
    for (std::size_t i = 0; i < stays[v].size(); ++i) {
      if (!stays[v][i]) continue;
      cover.all[to] = cover.all[i], elimination_.least[v][to] = elimination_.least[v][i];
      std::copy_n(cover.terms.begin() + i * stride, stride, cover.terms.begin() + to * stride);
      std::copy_n(cover.tilts.begin() + i * width, width, cover.tilts.begin() + to * width);
      ++to;
    }
    cover.all.resize(to), elimination_.least[v].resize(to), cover.terms.resize(to * stride),
        cover.tilts.resize(to * width);
  }
}

}  // namespace seamwise
