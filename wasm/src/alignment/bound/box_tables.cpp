#include "alignment/bound/box_tables.h"

#include <algorithm>
#include <cmath>

namespace seamwise {

/// A bound from a term with tilted slopes.
float BoxTables::tilted(const float* term, const float* row, int rows, const float* column,
                        int columns) {
  float flat = term[0], slope = term[1];
  const float* g = term + 2;
  for (int k = 0; k < rows; ++k) flat -= std::abs(row[k]), slope -= std::abs(g[k] + row[k]);
  for (int k = 0; k < columns; ++k)
    flat -= std::abs(column[k]), slope -= std::abs(g[rows + k] + column[k]);
  return std::max(flat, slope);
}

BoxTables::BoxTables(const MatchProblem& problem, const Component& component)
    : problem_(problem), elimination_({}, {}) {
  std::vector<int> index(problem.leaders.size(), -1);
  bool free = true;
  for (const int s : component.seams)
    for (const int l : {problem.seams[s].a, problem.seams[s].b})
      free = free && !problem.leaders[l].admissible.isPinned();
  std::vector<double> sizes;
  for (const int l : component.leaders) {
    const AdmissibleAlignments& admissible = problem.leaders[l].admissible;
    if (admissible.isPinned()) continue;
    index[l] = leaders();
    const int slots = admissible.mayRotate() ? 3 : admissible.isMirrored() ? 1 : 2;
    covers_.push_back({Boxes(problem, l), slots == 3 ? 0 : 1, slots, 0, {}, {}, {}, {}, {}});
    covers_.back().all = covers_.back().boxes.all(free && index[l] == 0);
    sizes.push_back(slots == 3 ? 27e3 : slots == 2 ? 900 : 30);  // 30 per slot
  }
  std::vector<std::pair<int, int>> joined;
  bounds_.reserve(component.seams.size()), pinned_.reserve(component.seams.size());
  for (const int s : component.seams) {
    const MatchSeam& seam = problem.seams[s];
    const int a = index[seam.a], b = index[seam.b];
    if (a >= 0 && b >= 0 && a != b) joined.push_back({a, b});
  }
  elimination_ = Elimination(sizes, joined);
  joints_.resize(elimination_.tables.size());
  addSeams(component, index);
  for (std::size_t t = 0; t < joints_.size(); ++t) {
    Joint& joint = joints_[t];
    PairTable& table = elimination_.tables[t];
    Cover &row = covers_[table.row], &column = covers_[table.column];
    if (!joint.seams.empty()) {
      joint.stride = 2 + row.slots + column.slots;
      joint.row_tilt = row.slots * static_cast<int>(row.tables.size());
      joint.column_tilt = column.slots * static_cast<int>(column.tables.size());
      row.tables.push_back(static_cast<int>(t)), column.tables.push_back(static_cast<int>(t));
    }
    const int columns = static_cast<int>(column.all.size());
    table.begin = {0};
    for (std::size_t r = 0; r < row.all.size(); ++r) {
      for (int c = 0; c < columns; ++c) {
        table.to.push_back(c);
        table.least.push_back(0), joint.stale.push_back(1);
        joint.terms.resize(joint.terms.size() + joint.stride, 0.0f);
      }
      table.begin.push_back(table.entries());
    }
  }
  for (Cover& cover : covers_) {
    cover.terms.assign(cover.all.size() * cover.stride(), 0.0f);
    cover.tilts.assign(cover.all.size() * cover.tilted(), 0.0f);
  }
  for (int v = 0; v < leaders(); ++v) elimination_.least[v].assign(covers_[v].all.size(), 0.0f);
  sweep();
}

void BoxTables::addSeams(const Component& component, const std::vector<int>& index) {
  for (const int s : component.seams) {
    const MatchSeam& seam = problem_.seams[s];
    const int a = index[seam.a], b = index[seam.b];
    const SeamBound& bound = bounds_.emplace_back(problem_, seam);
    if (a < 0 || b < 0) {
      Cover& mine = covers_[std::max(a, b)];
      const int other = a < 0 ? seam.a : seam.b;
      const Leader& leader = problem_.leaders[other];
      pinned_.push_back({leader.admissible.nearest({0, leader.centre}, leader.centre)});
      mine.own.add(bound, a < 0, pinned_.back());
      mine.weight += seam.weight;
      continue;
    }
    covers_[a].weight += seam.weight, covers_[b].weight += seam.weight;
    if (a == b) {
      covers_[a].own.add(bound, false);
      continue;
    }
    for (std::size_t t = 0; t < joints_.size(); ++t) {
      const PairTable& table = elimination_.tables[t];
      if (table.row == a && table.column == b) joints_[t].seams.add(bound, false);
      if (table.row == b && table.column == a) joints_[t].seams.add(bound, true);
    }
  }
}

double BoxTables::bytesWith(int v, float below) const {
  double sum = 0;
  for (std::size_t t = 0; t < joints_.size(); ++t) {
    const PairTable& table = elimination_.tables[t];
    const double size = 17 + 4.0 * joints_[t].stride;
    sum += size * table.entries();
    const std::vector<float>& least = elimination_.least[v];
    if (table.row == v)
      for (std::size_t r = 0; r < least.size(); ++r)
        if (least[r] < below) sum += size * (table.begin[r + 1] - table.begin[r]);
    if (table.column == v)
      for (const int c : table.to)
        if (least[c] < below) sum += size;
  }
  return sum;
}

void BoxTables::halve(int v, float below, double& spent) {
  Cover& cover = covers_[v];
  std::vector<HalfBox> next;  // sign 0: unchanged
  std::vector<float> terms, tilts, least;
  std::vector<int> first;
  const int stride = cover.stride(), width = cover.tilted();
  for (std::size_t i = 0; i < cover.all.size(); ++i) {
    first.push_back(static_cast<int>(next.size()));
    std::vector<HalfBox> halves;
    if (elimination_.least[v][i] < below) halves = cover.boxes.halves(cover.all[i]);
    if (halves.empty()) halves.push_back({cover.all[i], 0, 0});
    for (const HalfBox& half : halves) {
      next.push_back(half);
      least.push_back(elimination_.least[v][i]);
      terms.insert(terms.end(), cover.terms.begin() + i * stride,
                   cover.terms.begin() + (i + 1) * stride);
      tilts.insert(tilts.end(), cover.tilts.begin() + i * width,
                   cover.tilts.begin() + (i + 1) * width);
      if (half.sign == 0) continue;
      for (int k = half.side - cover.slot; k < width; k += cover.slots)
        tilts[tilts.size() - width + k] /= 2;
      if (cover.own.empty()) continue;
      const Term term =
          cover.own.between(half.box, cover.boxes.reach(), half.box, cover.boxes.reach(), spent);
      float* own = terms.data() + terms.size() - stride;
      own[0] = std::max(own[0], term.known), own[1] = term.middle;
      for (int k = 0; k < cover.slots; ++k) own[2 + k] = term.slope[cover.slot + k];
    }
  }
  first.push_back(static_cast<int>(next.size()));
  for (int t = 0; t < static_cast<int>(joints_.size()); ++t)
    if (elimination_.tables[t].row == v || elimination_.tables[t].column == v)
      inherit(t, v, next, first);
  cover.all.clear();
  for (const HalfBox& half : next) cover.all.push_back(half.box);
  cover.terms.swap(terms), cover.tilts.swap(tilts), elimination_.least[v].swap(least);
}

/// Copies the entries of a table for the halves of the boxes of `v`.
void BoxTables::inherit(int t, int v, const std::vector<HalfBox>& halves,
                        const std::vector<int>& first) {
  PairTable& table = elimination_.tables[t];
  Joint& joint = joints_[t];
  PairTable next{table.row, table.column, {0}, {}, {}, {}};
  std::vector<float> terms;
  std::vector<char> stale;
  const std::size_t stride = joint.stride;
  std::size_t entries = 0;  // exact, since tables take most of the memory
  for (std::size_t r = 0; r + 1 < table.begin.size(); ++r)
    for (int e = table.begin[r]; e < table.begin[r + 1]; ++e) {
      const std::size_t box = table.row == v ? r : table.to[e];
      entries += first[box + 1] - first[box];
    }
  next.to.reserve(entries), next.least.reserve(entries);
  terms.reserve(entries * stride), stale.reserve(stride > 0 ? entries : 0);
  const int slot = 2 + (table.row == v ? 0 : covers_[table.row].slots) - covers_[v].slot;
  const auto add = [&](int c, int e, const HalfBox& half) {
    next.to.push_back(c), next.least.push_back(table.least[e]);
    if (stride == 0) return;
    terms.insert(terms.end(), joint.terms.begin() + e * stride,
                 joint.terms.begin() + (e + 1) * stride);
    stale.push_back(joint.stale[e] || half.sign != 0);
    if (half.sign == 0) return;
    float* term = terms.data() + terms.size() - stride;
    float& slope = term[slot + half.side];
    slope /= 2;
    term[1] += static_cast<float>(half.sign) * slope;
  };
  for (std::size_t r = 0; r + 1 < table.begin.size(); ++r) {
    if (table.row == v) {
      for (int n = first[r]; n < first[r + 1]; ++n) {
        for (int e = table.begin[r]; e < table.begin[r + 1]; ++e) add(table.to[e], e, halves[n]);
        next.begin.push_back(next.entries());
      }
    } else {
      for (int e = table.begin[r]; e < table.begin[r + 1]; ++e)
        for (int c = first[table.to[e]]; c < first[table.to[e] + 1]; ++c) add(c, e, halves[c]);
      next.begin.push_back(next.entries());
    }
  }
  table = std::move(next);
  joint.terms.swap(terms), joint.stale.swap(stale);
}

/// The table with the least work comes first, since it leaves little of the others.
bool BoxTables::evaluate() {
  double least = 0;
  for (std::size_t t = 0; t < joints_.size(); ++t) {
    const Joint& joint = joints_[t];
    const double stale = static_cast<double>(std::count(joint.stale.begin(), joint.stale.end(), 1));
    const double work = stale * joint.seams.weight();
    if (work > 0 && (table_ < 0 || work < least)) least = work, table_ = static_cast<int>(t);
  }
  row_ = 0;
  return table_ >= 0;
}

bool BoxTables::step(double work, double& spent) {
  const double until = spent + work;
  if (table_ >= 0) {
    const PairTable& table = elimination_.tables[table_];
    Joint& joint = joints_[table_];
    for (const int rows = static_cast<int>(table.begin.size()) - 1; row_ < rows; ++row_) {
      if (spent >= until) return true;
      for (int e = table.begin[row_]; e < table.begin[row_ + 1]; ++e)
        if (joint.stale[e]) evaluateEntry(joint, row_, e, spent);
    }
    table_ = -1;
    sweep();
  }
  return elimination_.step(until - spent, spent);
}

void BoxTables::evaluateEntry(Joint& joint, int r, int e, double& spent) {
  const PairTable& table = elimination_.tables[table_];
  const Cover &row = covers_[table.row], &column = covers_[table.column];
  const int c = table.to[e];
  const Term term = joint.seams.between(row.all[r], row.boxes.reach(), column.all[c],
                                        column.boxes.reach(), spent);
  float* to = &joint.terms[static_cast<std::size_t>(e) * joint.stride];
  *to = std::max(*to, term.known);
  *++to = term.middle;
  for (int k = 0; k < row.slots; ++k) *++to = term.slope[row.slot + k];
  for (int k = 0; k < column.slots; ++k) *++to = term.slope[3 + column.slot + k];
  joint.stale[e] = 0;
}

void BoxTables::sweep() {
  for (std::size_t t = 0; t < joints_.size(); ++t) {
    const Joint& joint = joints_[t];
    PairTable& table = elimination_.tables[t];
    table.cost.assign(table.to.size(), 0.0f);
    if (joint.stride == 0) continue;
    const Cover &row = covers_[table.row], &column = covers_[table.column];
    for (std::size_t r = 0; r < row.all.size(); ++r) {
      const float* mine = &row.tilts[r * row.tilted() + joint.row_tilt];
      for (int e = table.begin[r]; e < table.begin[r + 1]; ++e)
        table.cost[e] =
            tilted(&joint.terms[static_cast<std::size_t>(e) * joint.stride], mine, row.slots,
                   &column.tilts[table.to[e] * column.tilted() + joint.column_tilt], column.slots);
    }
  }
  for (int v = 0; v < leaders(); ++v) {
    const Cover& cover = covers_[v];
    elimination_.alone[v].resize(cover.all.size());
    const int own = cover.slots * static_cast<int>(cover.tables.size());
    for (std::size_t i = 0; i < cover.all.size(); ++i)
      elimination_.alone[v][i] =
          tilted(&cover.terms[i * cover.stride()], &cover.tilts[i * cover.tilted() + own],
                 cover.slots, nullptr, 0);
  }
  elimination_.begin();
}

}  // namespace seamwise
