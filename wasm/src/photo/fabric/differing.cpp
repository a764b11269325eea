#include "photo/fabric/differing.h"

#include <algorithm>
#include <cmath>

#include "base/disjoint_sets.h"
#include "base/sort_by.h"

namespace seamwise {

namespace {

/// Mean squared difference above which a place differs: kTimesMedian times the image's median plus
/// kShareOfPrint times the print's variance.
constexpr float kTimesMedian = 4, kShareOfPrint = 0.2f;
constexpr float kFoldSlope = 0.4f;  // slope of the shift at which fabric is no longer flat
constexpr float kLeastSteepness = 0.3f, kMostSteepness = 1.5f;
constexpr float kFewSamples = 0.1f;  // share of a full node's weight; nodes below are unknown

/// Sums per node of the shift's grid.
struct NodeSums {
  explicit NodeSums(std::size_t n) : count(n), squares(n), steep(n), mean_steep(n), area(n) {}
  std::vector<float> count, squares, steep, mean_steep, area;
  void add(const SplineShares& at, int columns, float difference, float both, float own,
           float size) {
    for (int j = 0; j < 4; ++j) {
      for (int i = 0; i < 4; ++i) {
        const std::size_t k = at.first + j * columns + i;
        const float w = at.across[i] * at.down[j];
        count[k] += w;
        squares[k] += w * difference;
        steep[k] += w * both;
        mean_steep[k] += w * own;
        area[k] += w * size;
      }
    }
  }
};

/// Returns the print's variance over all colours.
float printVariance(const CopyRegistration& registration) {
  float sum = 0;
  for (const std::vector<float>& plane : registration.mean()) {
    float mean = 0, squares = 0;
    for (const float v : plane) mean += v, squares += v * v;
    const float n = static_cast<float>(plane.size());
    sum += squares / n - mean * mean / (n * n);
  }
  return sum;
}

NodeSums nodeSumsOf(const CopyRegistration& registration) {
  const LatticeCanvas& canvas = registration.canvas();
  const SmoothField& shift = registration.shift();
  NodeSums sums(static_cast<std::size_t>(shift.columns) * shift.rows);
  const int n = canvas.n, width = canvas.columns();
  for (int b = 0; b + 1 < canvas.rows(); ++b) {
    for (int a = 0; a + 1 < width; ++a) {
      const int k = b * width + a;
      if (!canvas.seen[k] || !canvas.seen[k + 1] || !canvas.seen[k + width]) continue;
      const std::size_t place = canvas.place(a, b);
      const float copies = registration.count()[place];
      if (copies < 2) continue;
      const std::size_t right = canvas.place(a + 1, b), above = canvas.place(a, b + 1);
      const float others = copies / (copies - 1);
      float difference = 0, both = 0, own = 0;
      for (int c = 0; c < 3; ++c) {
        const std::vector<float>& mean = registration.mean()[c];
        const std::vector<float>& copy = canvas.planes[c];
        const float e = others * (mean[place] - copy[k]);
        const float mu = mean[right] - mean[place], mv = mean[above] - mean[place];
        difference += e * e;
        own += mu * mu + mv * mv;
        both += mu * (copy[k + 1] - copy[k]) + mv * (copy[k + width] - copy[k]);
      }
      const float xu = canvas.x[k + 1] - canvas.x[k], yu = canvas.y[k + 1] - canvas.y[k];
      const float xv = canvas.x[k + width] - canvas.x[k], yv = canvas.y[k + width] - canvas.y[k];
      sums.add(SplineShares(shift, canvas.x[k], canvas.y[k]), shift.columns, difference, both, own,
               std::abs(xu * yv - yu * xv) * static_cast<float>(n * n));
    }
  }
  return sums;
}

/// Returns the largest slope of the shift from a node to its right and lower neighbours.
float slopeAt(const SmoothField& shift, int i, int j) {
  const int right = i + 1 < shift.columns ? 2 : 0,
            below = j + 1 < shift.rows ? 2 * shift.columns : 0;
  const float* node = shift.nodes.data() + 2 * (static_cast<std::size_t>(j) * shift.columns + i);
  float most = 0;
  for (int c = 0; c < 2; ++c)
    most =
        std::max({most, std::abs(node[right + c] - node[c]), std::abs(node[below + c] - node[c])});
  return most / static_cast<float>(shift.step);
}

/// Collects rectangles around connected marked nodes.
void gatherRegions(const SmoothField& field, const std::vector<std::uint8_t>& marked,
                   CopyFields* fields) {
  DisjointSets sets(static_cast<int>(marked.size()));
  const int columns = field.columns;
  for (int k = 0; k < static_cast<int>(marked.size()); ++k) {
    if (!marked[k]) continue;
    if (k % columns > 0 && marked[k - 1]) sets.join(k, k - 1);
    if (k >= columns && marked[k - columns]) sets.join(k, k - columns);
  }
  std::vector<int> region_of(marked.size(), -1);
  for (int k = 0; k < static_cast<int>(marked.size()); ++k) {
    if (!marked[k]) continue;
    const Vec2 p = field.step * Vec2(k % columns - 1, k / columns - 1);
    const Vec2 half = Vec2::Constant(field.step / 2);
    const int first = sets.find(k);
    if (region_of[first] < 0) {
      region_of[first] = static_cast<int>(fields->regions.size());
      fields->regions.push_back({p - half, p + half});
    }
    DifferingRegion& region = fields->regions[region_of[first]];
    region.low = region.low.cwiseMin(p - half);
    region.high = region.high.cwiseMax(p + half);
  }
}

}  // namespace

void findDiffering(const CopyRegistration& registration, double cell_size, CopyFields* fields) {
  const SmoothField& shift = registration.shift();
  const NodeSums sums = nodeSumsOf(registration);
  const std::size_t n = sums.count.size();
  const float full = *std::max_element(sums.count.begin(), sums.count.end());
  std::vector<double> known;
  for (std::size_t k = 0; k < n; ++k)
    if (sums.count[k] > kFewSamples * full) known.push_back(sums.squares[k] / sums.count[k]);
  fields->weight = shift;
  fields->weight.channels = 1;
  fields->weight.nodes.assign(n, 1);
  if (known.empty()) return;
  sortNumbers(known);
  const float limit = kTimesMedian * static_cast<float>(known[known.size() / 2]) +
                      kShareOfPrint * printVariance(registration);
  float all = 0, steepness = 0;
  for (std::size_t k = 0; k < n; ++k) all += sums.count[k], steepness += sums.mean_steep[k];
  const float prior = 0.1f * steepness / static_cast<float>(n);
  const float cell_area = static_cast<float>(cell_size * cell_size);
  std::vector<std::uint8_t> marked(n);
  float differing = 0;
  for (std::size_t k = 0; k < n; ++k) {
    if (sums.count[k] <= kFewSamples * full) continue;
    const int i = static_cast<int>(k) % shift.columns, j = static_cast<int>(k) / shift.columns;
    marked[k] = sums.squares[k] / sums.count[k] > limit || slopeAt(shift, i, j) > kFoldSlope;
    const float steep = std::clamp((sums.steep[k] + prior) / (sums.mean_steep[k] + prior),
                                   kLeastSteepness, kMostSteepness);
    const float size = sums.area[k] / sums.count[k] / cell_area;
    fields->weight.nodes[k] = marked[k] ? 0.0f : steep * steep * size;
    if (marked[k]) differing += sums.count[k];
  }
  fields->differing = all > 0 ? differing / all : 0;
  gatherRegions(shift, marked, fields);
}

}  // namespace seamwise
