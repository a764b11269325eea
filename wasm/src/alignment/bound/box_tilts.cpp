#include <algorithm>

#include "alignment/bound/box_tables.h"

namespace seamwise {

/// Tilts of all boxes that make the slopes at each box's best partners cancel.
std::vector<std::vector<float>> BoxTables::balance() const {
  const auto& tables = elimination_.tables;
  std::vector<std::vector<int>> of_rows(tables.size()), of_columns(tables.size());
  for (std::size_t t = 0; t < tables.size(); ++t) {
    if (joints_[t].stride == 0) continue;
    const PairTable& table = tables[t];
    of_rows[t].assign(covers_[table.row].all.size(), -1);
    of_columns[t].assign(covers_[table.column].all.size(), -1);
    for (std::size_t r = 0; r < of_rows[t].size(); ++r)
      for (int e = table.begin[r]; e < table.begin[r + 1]; ++e)
        for (int* best : {&of_rows[t][r], &of_columns[t][table.to[e]]})
          if (*best < 0 || table.least[e] < table.least[*best]) *best = e;
  }
  std::vector<std::vector<float>> tilts(leaders());
  for (int v = 0; v < leaders(); ++v) {
    const Cover& cover = covers_[v];
    const float parts = static_cast<float>(cover.tables.size() + 1);
    for (std::size_t i = 0; i < cover.all.size(); ++i) {
      float sum[3] = {};
      const auto add = [&](const float* slope) {
        for (int k = 0; k < cover.slots; ++k) tilts[v].push_back(-slope[k]), sum[k] += slope[k];
      };
      for (const int t : cover.tables) {
        const bool row = tables[t].row == v;
        const std::size_t e = row ? of_rows[t][i] : of_columns[t][i];
        add(&joints_[t]
                 .terms[e * joints_[t].stride + 2 + (row ? 0 : covers_[tables[t].row].slots)]);
      }
      add(&cover.terms[i * cover.stride() + 2]);
      float* const mine = &tilts[v][i * cover.tilted()];
      for (int k = 0; k < cover.tilted(); ++k) mine[k] += sum[k % cover.slots] / parts;
    }
  }
  return tilts;
}

void BoxTables::tilt() {
  const std::vector<std::vector<float>> fresh = balance();
  const float flat[3] = {};
  // The least gain of each box over its current tilts, without tilts and with the fresh ones.
  struct Gain {
    float none, fresh;
  };
  std::vector<std::vector<Gain>> gains(leaders());
  for (int v = 0; v < leaders(); ++v) {
    const Cover& cover = covers_[v];
    const std::size_t width = cover.tilted();
    for (std::size_t i = 0; i < cover.all.size(); ++i) {
      const std::size_t own = (i + 1) * width - cover.slots;
      const auto with = [&](const float* tilts) {
        return tilted(&cover.terms[i * cover.stride()], tilts, cover.slots, nullptr, 0);
      };
      const float now = with(&cover.tilts[own]);
      gains[v].push_back({with(flat) - now, with(&fresh[v][own]) - now});
    }
  }
  for (std::size_t t = 0; t < joints_.size(); ++t) {
    const Joint& joint = joints_[t];
    if (joint.stride == 0) continue;
    const PairTable& table = elimination_.tables[t];
    const Cover &row = covers_[table.row], &column = covers_[table.column];
    const Gain most{Elimination::kNone, Elimination::kNone};
    std::vector<Gain> of_columns(column.all.size(), most);
    for (std::size_t r = 0; r < row.all.size(); ++r) {
      const std::size_t a = r * row.tilted() + joint.row_tilt;
      Gain of_row = most;
      for (int e = table.begin[r]; e < table.begin[r + 1]; ++e) {
        const int c = table.to[e];
        const std::size_t b = static_cast<std::size_t>(c) * column.tilted() + joint.column_tilt;
        const auto with = [&](const float* of_a, const float* of_b) {
          return tilted(&joint.terms[static_cast<std::size_t>(e) * joint.stride], of_a, row.slots,
                        of_b, column.slots);
        };
        const float *mine = &row.tilts[a], *other = &column.tilts[b];
        const float others = table.least[e] - with(mine, other);
        const float above_row = others - elimination_.least[table.row][r];
        const float above_column = others - elimination_.least[table.column][c];
        Gain& of_column = of_columns[c];
        of_row.none = std::min(of_row.none, above_row + with(flat, other));
        of_row.fresh = std::min(of_row.fresh, above_row + with(&fresh[table.row][a], other));
        of_column.none = std::min(of_column.none, above_column + with(mine, flat));
        of_column.fresh =
            std::min(of_column.fresh, above_column + with(mine, &fresh[table.column][b]));
      }
      gains[table.row][r].none += of_row.none, gains[table.row][r].fresh += of_row.fresh;
    }
    for (std::size_t c = 0; c < of_columns.size(); ++c) {
      Gain& gain = gains[table.column][c];
      gain.none += of_columns[c].none, gain.fresh += of_columns[c].fresh;
    }
  }
  for (int v = 0; v < leaders(); ++v) {
    Cover& cover = covers_[v];
    const std::size_t width = cover.tilted();
    for (std::size_t i = 0; i < cover.all.size(); ++i) {
      const Gain& gain = gains[v][i];
      float* const tilts = &cover.tilts[i * width];
      if (gain.none > std::max(0.0f, gain.fresh))
        std::fill_n(tilts, width, 0.0f);
      else if (gain.fresh > 0)
        std::copy_n(&fresh[v][i * width], width, tilts);
    }
  }
}

}  // namespace seamwise
