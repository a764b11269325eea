#include "symmetry/seam_maps.h"

#include <algorithm>
#include <numeric>

#include "base/sort_by.h"
#include "tuning/symmetry.h"

namespace seamwise {
namespace {

double probeFraction(int k) { return (2 * k + 1) / (2.0 * PieceMap::kProbes); }

// 0 if the map carries the grain line of one piece to that of the other, 2 if it reverses it.
double grainTurn(const Panel& from, const Panel& to, const RigidMotion& map) {
  return 1 - (map.linear() * unit(from.grain_angle)).dot(unit(to.grain_angle));
}

}  // namespace

Coverage Coverage::operator+(const Coverage& other) const {
  return {seams + other.seams, outline + other.outline, disagreement + other.disagreement,
          paired + other.paired};
}

bool Coverage::betterThan(const Coverage& other) const {
  const auto differs = [](double x, double y) {
    return std::abs(x - y) > SymmetryTuning::kNoticeable * std::max(x, y);
  };
  if (differs(seams, other.seams)) return seams > other.seams;
  if (differs(outline, other.outline)) return outline > other.outline;
  if (std::abs(disagreement - other.disagreement) > 1e-6 * (1 + disagreement))
    return disagreement < other.disagreement;
  return paired < other.paired;
}

SeamMaps::SeamMaps(const Garment& garment)
    : garment_(garment), placement_(garment), from_(garment.panels.size()) {
  outlines_.reserve(garment.panels.size());
  for (const Panel& panel : garment.panels) outlines_.emplace_back(panel);
  connect();
}

bool SeamMaps::advance() {
  while (searched_from_ < pieces()) {
    if (!search_) search_.emplace(outlines_[searched_from_], outlines_[searched_to_]);
    if (search_->advance()) return true;
    addMaps(searched_from_, searched_to_, search_->take());
    search_.reset();
    if (++searched_to_ == pieces()) searched_to_ = ++searched_from_;
  }
  return false;
}

double SeamMaps::fraction() const {
  const double n = pieces(), left = n - searched_from_, begun = searched_to_ - searched_from_;
  return n > 0 ? 1 - (left * (left + 1) / 2 - begun) / (n * (n + 1) / 2) : 1;
}

void SeamMaps::connect() {
  seams_.resize(outlines_.size());
  for (const Panel& panel : garment_.panels) partners_.emplace_back(panel.edges.size());
  for (std::size_t k = 0; k < garment_.stitches.size(); ++k) {
    const Stitch& stitch = garment_.stitches[k];
    partners_[stitch.a.piece][stitch.a.edge] = {stitch.b, stitch.same_direction};
    partners_[stitch.b.piece][stitch.b.edge] = {stitch.a, stitch.same_direction};
    lengths_.push_back((outlines_[stitch.a.piece].edgeLength(stitch.a.edge) +
                        outlines_[stitch.b.piece].edgeLength(stitch.b.edge)) /
                       2);
    seams_[stitch.a.piece].push_back(static_cast<int>(k));
    if (stitch.b.piece != stitch.a.piece) seams_[stitch.b.piece].push_back(static_cast<int>(k));
  }
  for (std::vector<int>& seams : seams_) sortBy(seams, [&](int seam) { return -lengths_[seam]; });
}

void SeamMaps::addMaps(int from, int to, const std::vector<MirrorRegistration>& registrations) {
  for (const MirrorRegistration& registration : registrations) {
    const int index = static_cast<int>(maps_.size());
    const bool single = from == to;
    for (const bool back : {false, true}) {
      if (back && single) break;
      PieceMap map;
      map.from = back ? to : from;
      map.to = back ? from : to;
      map.inverse = single ? index : back ? index : index + 1;
      map.registration = {back ? registration.map.inverse() : registration.map,
                          registration.residual};
      map.disagreement =
          placement_.disagreement(map.from, map.to, map.registration.map, outlines_[map.from]) +
          SymmetryTuning::kGrainWeight *
              grainTurn(garment_.panels[map.from], garment_.panels[map.to], map.registration.map);
      probe(map);
      from_[map.from].push_back(static_cast<int>(maps_.size()));
      maps_.push_back(std::move(map));
    }
  }
}

void SeamMaps::probe(PieceMap& map) const {
  map.probes.resize(garment_.panels[map.from].edges.size());
  for (std::size_t e = 0; e < map.probes.size(); ++e) {
    if (partners_[map.from][e].edge.piece < 0) continue;
    for (int k = 0; k < PieceMap::kProbes; ++k) {
      const Vec2 point = outlines_[map.from].at(static_cast<int>(e), probeFraction(k));
      map.probes[e][k] = probed(map.to, outlines_[map.to].nearest(map.registration.map(point)));
    }
  }
}

Probe SeamMaps::probed(int piece, const OutlinePoint& image) const {
  Probe probe;
  probe.image = image.point;
  if (image.edge < 0) return probe;
  const Partner& partner = partners_[piece][image.edge];
  probe.sewn_piece = partner.edge.piece;
  if (probe.sewn_piece < 0) return probe;
  probe.sewn = outlines_[probe.sewn_piece].at(
      partner.edge.edge, partner.same_direction ? image.fraction : 1 - image.fraction);
  return probe;
}

// Number of probes at which the image of the seam is a seam if `near` maps the near side (b if
// swapped) and `far` the far side.
int SeamMaps::agreeing(const Stitch& stitch, bool swapped, const PieceMap& near,
                       const PieceMap& far) const {
  const EdgeRef &a = swapped ? stitch.b : stitch.a, &b = swapped ? stitch.a : stitch.b;
  const double slack =
      std::min(SymmetryTuning::kSeamSlack,
               SymmetryTuning::kSeamSlackShare * outlines_[b.piece].edgeLength(b.edge));
  int count = 0;
  for (int k = 0; k < PieceMap::kProbes; ++k) {
    const Probe& probe = near.probes[a.edge][k];
    const int other = stitch.same_direction ? k : PieceMap::kProbes - 1 - k;
    if (probe.sewn_piece == far.to &&
        (far.probes[b.edge][other].image - probe.sewn).norm() <= slack)
      ++count;
  }
  return count;
}

// Index of the far side piece's map that carries this seam to a seam; -1 if there is none.
int SeamMaps::forced(const Stitch& stitch, bool swapped, const PieceMap& near) const {
  int best = -1, most = PieceMap::kProbes / 2 - 1;
  for (const int m : from_[swapped ? stitch.a.piece : stitch.b.piece])
    if (const int count = agreeing(stitch, swapped, near, maps_[m]); count > most) {
      most = count;
      best = m;
    }
  return best;
}

bool SeamMaps::assign(int map, Assignment& assignment, std::vector<int>& added) const {
  const PieceMap& m = maps_[map];
  if (assignment[m.from] >= 0 || assignment[m.to] >= 0) return false;
  assignment[m.from] = map;
  added.push_back(m.from);
  if (m.to != m.from) {
    assignment[m.to] = m.inverse;
    added.push_back(m.to);
  }
  return true;
}

std::vector<int> SeamMaps::propagate(int map, Assignment& assignment) const {
  std::vector<int> added;
  assign(map, assignment, added);
  for (std::size_t next = 0; next < added.size(); ++next) {
    const int piece = added[next];
    for (const int k : seams_[piece]) {
      const Stitch& stitch = garment_.stitches[k];
      const bool swapped = stitch.b.piece == piece;
      if (assignment[swapped ? stitch.a.piece : stitch.b.piece] >= 0) continue;
      if (const int m = forced(stitch, swapped, maps_[assignment[piece]]); m >= 0)
        assign(m, assignment, added);
    }
  }
  return added;
}

Coverage SeamMaps::coverage(const Assignment& assignment, const std::vector<int>& added) const {
  std::vector<char> fresh(outlines_.size(), 0);
  Coverage total;
  for (const int piece : added) {
    fresh[piece] = 1;
    const PieceMap& map = maps_[assignment[piece]];
    total.outline += outlines_[piece].length();
    total.disagreement += outlines_[piece].length() * map.disagreement;
    if (map.to != map.from) ++total.paired;
  }
  for (std::size_t k = 0; k < garment_.stitches.size(); ++k) {
    const Stitch& stitch = garment_.stitches[k];
    const int near = assignment[stitch.a.piece], far = assignment[stitch.b.piece];
    if (near < 0 || far < 0 || !(fresh[stitch.a.piece] || fresh[stitch.b.piece])) continue;
    total.seams +=
        lengths_[k] * agreeing(stitch, false, maps_[near], maps_[far]) / PieceMap::kProbes;
  }
  return total;
}

std::vector<int> SeamMaps::components() const {
  std::vector<int> label(outlines_.size());
  std::iota(label.begin(), label.end(), 0);
  for (bool changed = true; changed;) {
    changed = false;
    for (const Stitch& stitch : garment_.stitches) {
      int &a = label[stitch.a.piece], &b = label[stitch.b.piece];
      if (a == b) continue;
      a = b = std::min(a, b);
      changed = true;
    }
  }
  return label;
}

}  // namespace seamwise
