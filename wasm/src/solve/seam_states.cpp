#include "solve/seam_states.h"

#include <algorithm>

#include "methods/seam_rules.h"
#include "solve/seam_reasons.h"

namespace seamwise {
namespace {

/// Least share of a seam's length within the tolerance of its state.
constexpr double kMostOfIt = 0.95;
/// Length of an unmatched end up to which the rest decides: in cm, and as a share of the seam.
constexpr double kEndLength = 3, kEndShare = 0.1;
/// Least length of an unmatched end worth a report. [cm]
constexpr double kLeastEnd = 0.5;

/// An edge of a seam: its length and its mismatch. [cm]
struct Edge {
  double length, mismatch;
};

/// Edges of the group's counted stitches, along the outline of its first side's piece.
std::vector<Edge> edgesOf(const WallpaperGroup& group, const SeamGroup& of, const Result& result) {
  const int piece = result.pattern.seams[of.seams.front()].a.piece;
  const int count = static_cast<int>(result.pattern.pieces[piece].outline.size());
  std::vector<Edge> all;
  for (const int s : of.seams) {
    const Seam& seam = result.pattern.seams[s];
    if (!counts(seam)) continue;
    const SeamMidpoints m = seamMidpoints(seam, result.shapes, result.alignment);
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < m.x.size(); ++i)
      edges.push_back({m.length[i], group.distance(m.x[i], m.y[i])});
    const std::vector<int>& along = (seam.a.piece == piece ? seam.a : seam.b).vertices;
    if ((along[0] + 1) % count != along[1]) std::reverse(edges.begin(), edges.end());
    all.insert(all.end(), edges.begin(), edges.end());
  }
  return all;
}

struct Shares {
  double length = 0;  ///< [cm]
  double seen = 0, close = 0;
};

/// Lengths of edges within the visible mismatch and within twice as much.
Shares sharesOf(const std::vector<Edge>& edges, std::size_t first, std::size_t last) {
  Shares shares;
  for (std::size_t i = first; i < last; ++i) {
    const auto& [length, mismatch] = edges[i];
    shares.length += length;
    if (mismatch <= kSeenMismatch) shares.seen += length;
    if (mismatch <= 2 * kSeenMismatch) shares.close += length;
  }
  return shares;
}

bool isImpossible(const SeamObstacle& obstacle, double reach) {
  if (obstacle.reason == SeamReason::kGather) return true;
  const bool by_rule =
      obstacle.reason == SeamReason::kGrain || obstacle.reason == SeamReason::kGroup;
  return by_rule && obstacle.left > reach;
}

/// The state by lengths alone, and an end that mismatches while the rest matches.
void judge(const std::vector<Edge>& edges, const SeamGroup& of, GroupFigures* figures) {
  const std::size_t count = edges.size();
  const Shares all = sharesOf(edges, 0, count);
  figures->state = all.seen >= kMostOfIt * all.length    ? SeamState::kMatches
                   : all.close >= kMostOfIt * all.length ? SeamState::kClose
                                                         : SeamState::kOff;
  std::size_t first = 0, last = count;  // the edges that do not mismatch begin and end here
  while (first < last && edges[first].mismatch > kSeenMismatch) ++first;
  while (first < last && edges[last - 1].mismatch > kSeenMismatch) --last;
  if (first == last) return;
  const double start = sharesOf(edges, 0, first).length, end = sharesOf(edges, last, count).length;
  const bool at_start = start >= end;
  const double cm = std::max(start, end);
  const Shares rest = at_start ? sharesOf(edges, first, count) : sharesOf(edges, 0, last);
  if (cm < kLeastEnd || rest.seen < kMostOfIt * rest.length) return;
  const bool is_short = cm <= std::max(kEndLength, kEndShare * all.length) && cm < all.length / 2;
  if (!is_short) return;
  figures->end = UnmatchedEnd{of.ends[at_start ? 0 : 1], cm};
  if (figures->state == SeamState::kOff) figures->state = SeamState::kClose;
}

}  // namespace

std::vector<GroupFigures> seamStates(const WallpaperGroup& group, const MatchProblem& match,
                                     const std::vector<EdgeRef>& locked,
                                     const std::vector<SeamGroup>& groups, double reach,
                                     const Result& result) {
  std::vector<GroupFigures> all;
  for (const SeamGroup& of : groups) {
    GroupFigures figures;
    const std::vector<Edge> edges = edgesOf(group, of, result);
    if (edges.empty()) {
      const bool any = std::any_of(of.seams.begin(), of.seams.end(),
                                   [&](int s) { return result.pattern.seams[s].matched; });
      figures.state = any ? SeamState::kMatches : SeamState::kChoice;
    } else {
      judge(edges, of, &figures);
    }
    if (figures.state == SeamState::kOff || figures.state == SeamState::kClose) {
      double worst = -1;
      bool impossible = true;
      for (const int s : of.seams) {
        const Seam& seam = result.pattern.seams[s];
        if (!counts(seam)) continue;
        const SeamObstacle obstacle = obstacleOf(result.pattern, seam, match, locked);
        if (result.figures[s].final > kSeenMismatch)
          impossible = impossible && isImpossible(obstacle, reach);
        if (result.figures[s].final > worst)
          worst = result.figures[s].final, figures.reason = obstacle.reason;
      }
      if (figures.state == SeamState::kOff && worst > kSeenMismatch && impossible)
        figures.state = SeamState::kCannot;
    }
    all.push_back(figures);
  }
  return all;
}

}  // namespace seamwise
