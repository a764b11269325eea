#include "alignment/model/matching.h"

#include <algorithm>
#include <limits>

namespace seamwise {
double MatchProblem::cost(const Alignments& at) const {
  double total = 0;
  for (const MatchSeam& seam : seams) {
    for (std::size_t i = 0; i < seam.w.size(); ++i) {
      const Vec2 x = at[seam.a].toPrint(seam.pa[i]), y = at[seam.b].toPrint(seam.pb[i]);
      double least = std::numeric_limits<double>::max();
      for (const Element& e : group.elements())
        if (allows(seam, e)) least = std::min(least, group.reduce(x - e(y)).squaredNorm());
      total += seam.w[i] * std::sqrt(least);
    }
  }
  return total;
}

Alignments MatchProblem::expanded(const Alignments& of_leaders) const {
  Alignments all(pieces.size());
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const Follow& f = pieces[p];
    all[p] = f.mirrored ? mirroredOnGrain(group, f.map, f.angles, of_leaders[f.leader])
                        : of_leaders[f.leader];
  }
  return all;
}

Alignments MatchProblem::ofLeaders(const Alignments& of_pieces) const {
  Alignments at(leaders.size());
  for (std::size_t l = 0; l < leaders.size(); ++l)
    at[l] = leaders[l].admissible.nearest(of_pieces[leaders[l].piece], leaders[l].centre);
  return at;
}

namespace {

/// Adds the weights of `seam` to `listed` if it has the same pairs, in either direction. Returns
/// whether it has.
bool mergedInto(MatchSeam& listed, const MatchSeam& seam, bool swapped) {
  const auto& pa = swapped ? seam.pb : seam.pa;
  const auto& pb = swapped ? seam.pa : seam.pb;
  const std::size_t n = seam.w.size();
  if (listed.w.size() != n || listed.reversing != seam.reversing) return false;
  if (listed.a != (swapped ? seam.b : seam.a) || listed.b != (swapped ? seam.a : seam.b))
    return false;
  for (bool reverse : {false, true}) {
    bool equal = true;
    for (std::size_t i = 0; i < n && equal; ++i) {
      const std::size_t k = reverse ? n - 1 - i : i;
      equal = (listed.pa[i] - pa[k]).norm() < 1e-6 && (listed.pb[i] - pb[k]).norm() < 1e-6;
    }
    if (!equal) continue;
    for (std::size_t i = 0; i < n; ++i) listed.w[i] += seam.w[reverse ? n - 1 - i : i];
    listed.weight += seam.weight;
    return true;
  }
  return false;
}

void reflect(std::vector<Vec2>& points, const RigidMotion& map) {
  for (Vec2& p : points) p = map(p);
}

/// Adds a seam given on pieces. The mirror image of a listed seam has the same condition and only
/// adds its weight. The images under a pair coincide on the leader; on a piece symmetric in itself
/// they are `own` reflections of each other.
void addSeam(MatchProblem& problem, const std::vector<RigidMotion>& back,
             const std::vector<const Mirror*>& own, MatchSeam seam) {
  const auto &fa = problem.pieces[seam.a], &fb = problem.pieces[seam.b];
  const Mirror *own_a = own[seam.a], *own_b = own[seam.b];
  auto follow = [](const RigidMotion& map, std::vector<Vec2>& points,
                   std::vector<Vec2>& directions) {
    reflect(points, map);
    for (Vec2& d : directions) d = map.linear() * d;
  };
  if (fa.mirrored) follow(back[seam.a], seam.pa, seam.da);
  if (fb.mirrored) follow(back[seam.b], seam.pb, seam.db);
  for (double w : seam.w) seam.weight += w;
  seam.a = fa.leader, seam.b = fb.leader;
  seam.reversing = fa.mirrored != fb.mirrored;
  if (seam.weight <= 0) return;
  // A seam of a piece to its own mirror twin meets under any alignment.
  bool twin = seam.a == seam.b;
  for (std::size_t i = 0; i < seam.w.size() && twin; ++i)
    twin = (seam.pa[i] - seam.pb[i]).norm() < 1e-6;
  if (twin) return;
  for (bool turn_a : {false, true}) {
    for (bool turn_b : {false, true}) {
      if ((turn_a && !own_a) || (turn_b && !own_b)) continue;
      MatchSeam image = seam;
      if (turn_a) reflect(image.pa, own_a->map);
      if (turn_b) reflect(image.pb, own_b->map);
      image.reversing = seam.reversing != (turn_a != turn_b);
      for (MatchSeam& listed : problem.seams)
        if (mergedInto(listed, image, false) || mergedInto(listed, image, true)) return;
    }
  }
  problem.seams.push_back(std::move(seam));
}

}  // namespace

Stretch MatchSeam::stretch(std::size_t first, std::size_t last) const {
  Stretch part;
  double total = 0;
  for (std::size_t i = first; i < last; ++i) {
    total += w[i];
    part.mean_a += w[i] * pa[i], part.mean_b += w[i] * pb[i];
  }
  part.mean_a /= total, part.mean_b /= total;
  // Each edge about the mean, and about its own middle.
  for (std::size_t i = first; i < last; ++i)
    part.covariance += w[i] * ((pa[i] - part.mean_a) * (pb[i] - part.mean_b).transpose() +
                               da[i] * db[i].transpose() / 12);
  return part;
}

MatchProblem makeMatchProblem(const Pattern& pattern, const Shapes& shapes,
                              const std::vector<Mirror>& mirrors, const MatchRules& rules,
                              const WallpaperGroup& group) {
  MatchProblem problem(group);
  problem.continuous_only = rules.continuous_only;
  problem.pieces.resize(pattern.pieces.size());
  std::vector<RigidMotion> back(pattern.pieces.size());
  std::vector<PieceRule> led = rules.pieces;  // includes the rules of a leader's image
  std::vector<const Mirror*> own(pattern.pieces.size(), nullptr);
  for (const Mirror& m : mirrors) {
    if (m.single()) {
      own[m.pieces[0]] = &m;
    } else {
      // A pinned twin leads.
      const bool second_leads = rules.pieces[m.pieces[1]].pin && !rules.pieces[m.pieces[0]].pin;
      const int follower = m.pieces[second_leads ? 0 : 1], leader = m.pieces[second_leads ? 1 : 0];
      const RigidMotion map = second_leads ? m.map.inverse() : m.map;
      const PieceRule& rule = rules.pieces[follower];
      problem.pieces[follower] = {leader, true, map,
                                  rule.pin ? std::vector{rule.pin->angle} : rule.angles};
      back[follower] = map.inverse();
      led[leader] = withImage(group, map, led[leader], rule);
    }
  }
  std::vector<int> leader_of(pattern.pieces.size(), -1);
  for (std::size_t p = 0; p < pattern.pieces.size(); ++p) {
    if (problem.pieces[p].mirrored) continue;
    leader_of[p] = static_cast<int>(problem.leaders.size());
    problem.pieces[p].leader = leader_of[p];
    Leader leader;
    leader.piece = static_cast<int>(p);
    for (int v : pattern.pieces[p].outline) leader.centre += shapes[p][v];
    leader.centre /= static_cast<double>(pattern.pieces[p].outline.size());
    const PieceRule& rule = led[p];
    if (own[p]) leader.admissible = AdmissibleAlignments::mirrored(own[p]->map, group);
    // Symmetry has precedence over the grain in a search for starts of other searches.
    if (!rule.angles.empty()) leader.admissible.restrictAngles(rule.angles, rule.tolerance);
    if (rule.pin)
      leader.admissible =
          AdmissibleAlignments::pinned(leader.admissible.nearest(*rule.pin, leader.centre));
    problem.leaders.push_back(std::move(leader));
  }
  for (MatchProblem::Follow& follow : problem.pieces)
    if (follow.mirrored) follow.leader = leader_of[follow.leader];

  for (std::size_t s = 0; s < pattern.seams.size(); ++s) {
    const Seam& seam = pattern.seams[s];
    if (!seam.matched || seam.twin) continue;
    MatchSeam m;
    m.a = seam.a.piece, m.b = seam.b.piece, m.seam = static_cast<int>(s);
    const auto& A = shapes[m.a];
    const auto& B = shapes[m.b];
    for (std::size_t i = 0; i + 1 < seam.a.vertices.size(); ++i) {
      const Vec2 &a0 = A[seam.a.vertices[i]], &a1 = A[seam.a.vertices[i + 1]];
      const Vec2 &b0 = B[seam.b.vertices[i]], &b1 = B[seam.b.vertices[i + 1]];
      m.pa.push_back((a0 + a1) / 2), m.pb.push_back((b0 + b1) / 2);
      m.da.push_back(a1 - a0), m.db.push_back(b1 - b0);
      m.w.push_back(seam.weight * ((a1 - a0).norm() + (b1 - b0).norm()) / 2);
    }
    addSeam(problem, back, own, std::move(m));
  }
  for (const MatchLine& line : rules.lines) {
    MatchSeam m;
    m.a = line.piece_a, m.b = line.piece_b;
    for (std::size_t i = 0; i + 1 < line.a.size(); ++i) {
      m.pa.push_back((line.a[i] + line.a[i + 1]) / 2);
      m.pb.push_back((line.b[i] + line.b[i + 1]) / 2);
      m.da.push_back(line.a[i + 1] - line.a[i]), m.db.push_back(line.b[i + 1] - line.b[i]);
      m.w.push_back(line.weight * (m.da.back().norm() + m.db.back().norm()) / 2);
    }
    addSeam(problem, back, own, std::move(m));
  }
  for (MatchSeam& seam : problem.seams) seam.whole = seam.stretch(0, seam.w.size());
  for (std::size_t s = 0; s < problem.seams.size(); ++s) {
    problem.leaders[problem.seams[s].a].seams.push_back(static_cast<int>(s));
    if (problem.seams[s].b != problem.seams[s].a)
      problem.leaders[problem.seams[s].b].seams.push_back(static_cast<int>(s));
  }
  return problem;
}

}  // namespace seamwise
