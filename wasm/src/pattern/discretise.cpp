#include "pattern/discretise.h"

#include <algorithm>
#include <cmath>

#include "base/in_quotes.h"
#include "pattern/breakpoints.h"
#include "pattern/sampling.h"
#include "pattern/seam_measure.h"

namespace seamwise {
namespace {

constexpr double kLongestEdge = 1.05;       // cm; coarser sampling of a seam would hide mismatch
constexpr double kGreatestDeviation = 0.5;  // cm; limit for outlines that are mirror images
constexpr double kCornerTolerance = 1e-3;   // cm
constexpr std::size_t kFewPerCorner = 6;

std::string called(const Panel& panel) { return "piece " + inQuotes(panel.name); }

std::optional<Error> firstFault(const Garment& garment, double edge_length) {
  if (!(edge_length > 0) || !std::isfinite(edge_length))
    return Error{Failure::kOptions, "the edge length must be a positive number of centimetres"};
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    const Panel& panel = garment.panels[p];
    auto loops = panel.holes;
    loops.push_back(panel.edges);
    for (const auto& loop : loops) {
      if (loop.empty())
        return Error{Failure::kMesh, called(panel) + " has an outline without edges",
                     static_cast<int>(p)};
      for (const Curve& c : loop)
        if (!(c.length() > 0) || !std::isfinite(c.length()))
          return Error{Failure::kEdgeZeroLength, called(panel) + " has an edge without length",
                       static_cast<int>(p)};
    }
  }
  return {};
}

bool samePieces(const BodySymmetry& a, const BodySymmetry& b) {
  return (a.pieces[0] == b.pieces[0] && a.pieces[1] == b.pieces[1]) ||
         (a.pieces[0] == b.pieces[1] && a.pieces[1] == b.pieces[0]);
}

/// The ties of one symmetry's outline and cut-outs; empty if some loop has no image.
std::optional<std::vector<LoopTie>> tiesOf(const Outlines& outlines, const BodySymmetry& symmetry,
                                           int number) {
  const int a = outlines.first[symmetry.pieces[0]], b = outlines.first[symmetry.pieces[1]];
  const auto end = [&](int first) {
    int l = first;
    while (l < static_cast<int>(outlines.loops.size()) &&
           outlines.loops[l].panel == outlines.loops[first].panel)
      ++l;
    return l;
  };
  if (end(a) - a != end(b) - b) return {};
  std::vector<LoopTie> ties;
  std::vector<char> taken(end(b) - b, false);
  for (int l = a; l < end(a); ++l) {
    // The outline maps to the outline, a cut-out to the nearest free one.
    int image = b;
    if (l > a) {
      const Vec2 middle = symmetry.map(outlines.loops[l].loop.middle());
      const auto distance = [&](int k) {
        return (outlines.loops[k].loop.middle() - middle).norm();
      };
      for (int k = b + 1; k < end(b); ++k)
        if (!taken[k - b] && (image == b || distance(k) < distance(image))) image = k;
    }
    if (image == b && l > a) return {};
    taken[image - b] = true;
    if (symmetry.single() && image < l) {
      const bool known = std::any_of(
          ties.begin(), ties.end(), [&](const LoopTie& t) { return t.from == image && t.to == l; });
      if (!known) return {};
      continue;
    }
    const Loop &from = outlines.loops[l].loop, &to = outlines.loops[image].loop;
    auto map = l == image ? correspondToItself(from, symmetry.map, kGreatestDeviation)
                          : correspond(from, to, symmetry.map, kGreatestDeviation);
    if (!map) return {};
    ties.push_back({l, image, number, *std::move(map)});
  }
  return ties;
}

/// Image of every outline and hole vertex under one imposed symmetry.
std::vector<int> imagesUnder(const Outlines& outlines, const Breakpoints& breakpoints,
                             const std::vector<SampledLoop>& sampled, const std::vector<int>& base,
                             int symmetry) {
  std::vector<int> image;
  for (std::size_t t = 0; t < outlines.ties.size(); ++t) {
    const LoopTie& tie = outlines.ties[t];
    if (tie.symmetry != symmetry) continue;
    const SampledLoop &from = sampled[tie.from], &to = sampled[tie.to];
    const int n = static_cast<int>(from.points.size());
    const int first = to.node_vertex[breakpoints.image_of_first[t]];
    const std::size_t end = base[tie.from] + n;
    if (image.size() < end) image.resize(end, -1);
    for (int v = 0; v < n; ++v) {
      const int w = ((first - v) % n + n) % n;
      image[base[tie.from] + v] = base[tie.to] + w;
      const bool within = outlines.loops[tie.from].panel == outlines.loops[tie.to].panel;
      if (!within || tie.from == tie.to) continue;
      image.resize(std::max(image.size(), static_cast<std::size_t>(base[tie.to] + n)), -1);
      image[base[tie.to] + w] = base[tie.from] + v;
    }
  }
  return image;
}

Pattern assembled(const Garment& garment, const Outlines& outlines, const Breakpoints& breakpoints,
                  const std::vector<SampledLoop>& sampled,
                  const std::vector<BodySymmetry>& imposed) {
  Pattern pattern;
  pattern.pieces.resize(garment.panels.size());
  std::vector<int> base;  // first vertex of each loop in its piece
  for (std::size_t l = 0; l < sampled.size(); ++l) {
    Piece& piece = pattern.pieces[outlines.loops[l].panel];
    base.push_back(static_cast<int>(piece.rest.size()));
    std::vector<int> ring(sampled[l].points.size());
    for (std::size_t v = 0; v < ring.size(); ++v) ring[v] = base.back() + static_cast<int>(v);
    piece.rest.insert(piece.rest.end(), sampled[l].points.begin(), sampled[l].points.end());
    if (outlines.loops[l].index == 0) {
      piece.outline = ring;
      piece.edge_start = sampled[l].edge_start;
    } else {
      piece.holes.push_back(ring);
    }
  }
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    pattern.pieces[p].name = garment.panels[p].name;
    pattern.pieces[p].mirrored_from_input = garment.panels[p].mirrored_from_input;
  }
  for (std::size_t s = 0; s < imposed.size(); ++s)
    pattern.mirrors.push_back(
        {{imposed[s].pieces[0], imposed[s].pieces[1]},
         imposed[s].map,
         imagesUnder(outlines, breakpoints, sampled, base, static_cast<int>(s))});
  const auto side = [&](const EdgeRef& ref, bool backwards) {
    const Piece& piece = pattern.pieces[ref.piece];
    const int n = static_cast<int>(piece.outline.size());
    const int edges = static_cast<int>(piece.edge_start.size());
    const int from = piece.edge_start[ref.edge];
    const int to = ref.edge + 1 < edges ? piece.edge_start[ref.edge + 1] : n;
    SeamSide out{ref.piece, {}};
    for (int v = from; v <= to; ++v) out.vertices.push_back(v % n);
    if (backwards) std::reverse(out.vertices.begin(), out.vertices.end());
    return out;
  };
  for (const Stitch& s : garment.stitches)
    pattern.seams.push_back({side(s.a, false), side(s.b, !s.same_direction), s.weight, s.matched,
                             1.0, false, s.visibility});
  setLengthRatios(pattern);
  return pattern;
}

}  // namespace

Outcome<Pattern> discretise(const Garment& garment, const std::vector<BodySymmetry>& sampled,
                            const std::vector<BodySymmetry>& imposed, double edge_length,
                            Effort effort) {
  if (const auto fault = firstFault(garment, edge_length)) return *fault;
  Outlines outlines;
  outlines.stitches = garment.stitches;
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    const Panel& panel = garment.panels[p];
    outlines.first.push_back(static_cast<int>(outlines.loops.size()));
    outlines.loops.push_back({static_cast<int>(p), 0, Loop(&panel.edges)});
    for (std::size_t h = 0; h < panel.holes.size(); ++h)
      outlines.loops.push_back(
          {static_cast<int>(p), static_cast<int>(h) + 1, Loop(&panel.holes[h])});
  }

  // Imposed symmetries come first and must work; the others only improve the sampling.
  for (std::size_t s = 0; s < imposed.size(); ++s) {
    auto ties = tiesOf(outlines, imposed[s], static_cast<int>(s));
    if (!ties)
      return Error{Failure::kMesh,
                   called(garment.panels[imposed[s].pieces[0]]) +
                       " cannot be matched point by point with its mirror image; check its axis or "
                       "leave out that symmetry",
                   imposed[s].pieces[0]};
    std::move(ties->begin(), ties->end(), std::back_inserter(outlines.ties));
  }
  Outlines demands = outlines;
  for (const BodySymmetry& s : sampled) {
    if (std::any_of(imposed.begin(), imposed.end(),
                    [&](const BodySymmetry& other) { return samePieces(s, other); }))
      continue;
    if (auto ties = tiesOf(outlines, s, -1))
      std::move(ties->begin(), ties->end(), std::back_inserter(demands.ties));
  }

  // Exact patterns need no tolerance. If symmetries and seams disagree, the least tolerance at
  // which propagation ends is best. If it does not end with few vertices, many are better than
  // failing.
  edge_length = std::min(edge_length, kLongestEdge);
  std::size_t corners = 0;
  double length = 0;
  for (const PanelLoop& l : outlines.loops) {
    corners += l.loop.corners().size();
    length += l.loop.length();
  }
  const std::size_t few = kFewPerCorner * corners;
  const std::size_t many = 2 * few + static_cast<std::size_t>(length / edge_length);
  double measured = kCornerTolerance;
  for (const LoopTie& t : demands.ties) measured = std::max(measured, t.map.tolerance);
  std::vector<const Outlines*> attempts{&outlines};
  if (demands.ties.size() > outlines.ties.size()) attempts.insert(attempts.begin(), &demands);
  std::vector<std::size_t> limits{few};
  if (effort == Effort::kFull) limits.push_back(many);
  Breakpoints breakpoints;
  for (const Outlines* attempt : attempts) {
    for (const std::size_t most : limits) {
      // If propagation does not end at the greatest tolerance, it does not end at any other.
      breakpoints = findBreakpoints(*attempt, 0.5 * edge_length, most, false);
      if (!breakpoints.conflict.empty()) continue;
      for (const double tolerance : {kCornerTolerance, measured, 0.03 * edge_length,
                                     0.1 * edge_length, 0.3 * edge_length, 0.5 * edge_length}) {
        breakpoints = findBreakpoints(*attempt, tolerance, most);
        if (!breakpoints.conflict.empty()) continue;
        auto loops = sampleLoops(*attempt, breakpoints, edge_length);
        if (loops.ok()) return assembled(garment, *attempt, breakpoints, loops.value(), imposed);
        Error error = loops.error();
        error.message = called(garment.panels[error.piece]) + ": " + error.message;
        return error;
      }
    }
  }
  return Error{Failure::kMesh,
               called(garment.panels[breakpoints.conflicting_panel]) + ": " + breakpoints.conflict +
                   "; leave out one of the symmetries it takes part in",
               breakpoints.conflicting_panel};
}

}  // namespace seamwise
