#include "solve/seam_figures.h"

#include <algorithm>
#include <utility>

#include "methods/seam_rules.h"
#include "tuning/shaping.h"

namespace seamwise {
namespace {

constexpr double kFarOff = 0.5;  ///< cm
constexpr double kMost = 0.9;    ///< share of all seams, by length

}  // namespace

void fillSeamFigures(const WallpaperGroup& group, const MatchProblem& match,
                     const std::vector<EdgeRef>& locked, Result& result) {
  const Pattern& pattern = result.pattern;
  const Shapes rest = restShapes(pattern);
  LocalMeans& all = result.local;
  all = {};
  result.figures.assign(pattern.seams.size(), {});
  std::vector<std::pair<double, double>> edges;  // mismatch and length of those that count
  double total = 0;
  for (std::size_t s = 0; s < pattern.seams.size(); ++s) {
    const Seam& seam = pattern.seams[s];
    SeamFigures& of = result.figures[s];
    of.drafted = localMismatch(group, seam, rest, result.drafted);
    of.placed = localMismatch(group, seam, rest, result.search);
    of.final = localMismatch(group, seam, result.shapes, result.alignment);
    of.shaped = seamMovement(seam, pattern, result.shapes) > ShapingTuning::kStraight;
    const SeamMidpoints m = seamMidpoints(seam, result.shapes, result.alignment);
    double length = 0;
    for (std::size_t i = 0; i < m.length.size(); ++i) {
      length += m.length[i];
      of.whole += m.length[i] * result.mismatch[s][i];
      if (counts(seam)) edges.emplace_back(group.distance(m.x[i], m.y[i]), m.length[i]);
    }
    of.whole /= length;
    if (!counts(seam)) continue;
    if (of.final > kSeenMismatch) of.reason = obstacleOf(pattern, seam, match, locked).reason;
    total += length;
    all.drafted += length * of.drafted, all.placed += length * of.placed;
    all.final += length * of.final;
    all.worst = std::max(all.worst, of.final);
  }
  if (total <= 0) return;
  std::sort(edges.begin(), edges.end());
  double met = 0;
  for (const auto& [mismatch, length] : edges) {
    if (met < kMost * total) all.p90 = mismatch;
    met += length;
    if (mismatch > kFarOff) all.off += length;
  }
  all.drafted /= total, all.placed /= total, all.final /= total;
}

}  // namespace seamwise
