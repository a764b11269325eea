#include "problem/seam_groups.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/disjoint_sets.h"
#include "drape/piece_words.h"
#include "problem/worn_layout.h"

namespace seamwise {
namespace {

/// Greatest turn between two stitches of one seam, on at least one of its pieces. [rad]
constexpr double kSameLine = 60 * kPi / 180;
/// Least share of a side's outward direction that points up or down where the side runs across the
/// body. [1]
constexpr double kAcross = 0.7;
/// Share of the body's depth up to which a piece is at the side. [1]
constexpr double kAtSide = 0.3;
/// Distance from the middle up to which a seam is in the middle. [cm]
constexpr double kMiddle = 3;
/// Greatest breadth of a band, of one between bodice and skirt, and least lengths as multiples of
/// them. [cm, cm, 1]
constexpr double kBandBreadth = 9, kWaistBreadth = 16, kBandLength = 3, kWaistLength = 2.5;
/// Least length of the ends of a band, over its breadth; a gusset or godet is pointed. [1]
constexpr double kBluntEnds = 0.7;
/// Greatest rise of a piece's length that runs across the body. [1]
constexpr double kLevel = 0.5;
/// Number of outline points that are enough to measure a piece.
constexpr std::size_t kMostPoints = 200;
/// Least height of a hood. [cm]
constexpr double kHoodHeight = 16;
/// Share of the torso's height above which a seam across is a yoke's. [1]
constexpr double kYokeHeight = 0.7;
/// Number of stitches above which places are not worth their time. Chosen.
constexpr std::size_t kMostStitches = 2000;
/// Weight of a gathered seam, and greatest length ratio of another.
constexpr double kGatheredWeight = 0.1, kEased = 1.1;
/// Weight of matched lines.
constexpr double kMatchedLineWeight = 2;

constexpr std::array<std::string_view, 5> kPocketWords = {"pocket", "tasche", "poche", "bolsillo",
                                                          "tasca"};
constexpr std::array<std::string_view, 5> kFacingWords = {"facing", "beleg", "parementure", "vista",
                                                          "paramontura"};
constexpr std::array<std::string_view, 5> kInsideWords = {"lining", "futter", "doublure", "forro",
                                                          "fodera"};

struct PlaceTable {
  const char* name;
  double front, side, back;  ///< visibility
};
/// Visibility by SeamPlace, chosen on solved garments. Seams seen from the front count most.
constexpr PlaceTable kPlaces[] = {{"other", 1.5, 1.5, 1.5},
                                  {"centre front", 3, 3, 3},
                                  {"centre back", 1.5, 1.5, 1.5},
                                  {"side", 2, 2, 2},
                                  {"shoulder", 2, 2, 2},
                                  {"princess", 3, 2, 1.5},
                                  {"yoke", 3, 2, 1.5},
                                  {"waist", 3, 2, 1.5},
                                  {"sleeve head, front", 2, 2, 2},
                                  {"sleeve head, back", 1, 1, 1},
                                  {"sleeve", 0.7, 0.7, 0.7},
                                  {"inseam", 1.5, 1.5, 1.5},
                                  {"outseam", 2, 2, 2},
                                  {"crotch", 1.5, 1.5, 1.5},
                                  {"band", 0.5, 0.5, 0.5},
                                  {"cuff", 0.5, 0.5, 0.5},
                                  {"collar", 0.5, 0.5, 0.5},
                                  {"hood", 0.5, 0.5, 0.5},
                                  {"pocket", 1, 1, 1},
                                  {"dart", 0.5, 0.5, 0.5},
                                  {"facing", 0.1, 0.1, 0.1},
                                  {"inside", 0.1, 0.1, 0.1}};

/// Angle by which the outline turns between an edge and the next. [rad]
double edgeTurn(const Panel& panel, int edge, int next) {
  return std::abs(turnBetween(panel.edges[edge].derivative(1), panel.edges[next].derivative(0)));
}

/// Returns whether two edges of a panel follow each other, and whether the outline goes straight
/// on.
struct Neighbours {
  bool adjacent = false, smooth = false;
};
Neighbours neighbours(const Panel& panel, int a, int b) {
  const int count = static_cast<int>(panel.edges.size());
  for (const auto& [one, next] : {std::pair(a, b), {b, a}})
    if (one != next && (one + 1) % count == next)
      return {true, edgeTurn(panel, one, next) < kSameLine};
  return {};
}

class Grouping {
 public:
  Grouping(const Garment& garment, const std::vector<BodySymmetry>& known)
      : garment_(garment), worn_(wornLayout(garment, known)) {
    for (std::size_t i = 0; i < worn_.at.size(); ++i)
      for (const Vec3& p : worn_.at[i])
        if (!worn_.arm[i] && !worn_.neck[i])
          lowest_ = std::min(lowest_, p.y()), highest_ = std::max(highest_, p.y());
    for (std::size_t i = 0; i < garment.panels.size(); ++i)
      band_.push_back(isBand(static_cast<int>(i)));
    for (const Seam& seam : worn_.sketch.seams)
      legs_ = legs_ || isInseam(sidesOf({static_cast<int>(&seam - worn_.sketch.seams.data())}));
  }

  SeamGroup place(std::vector<int> seams) const {
    const Sides sides = sidesOf(seams);
    SeamGroup group{std::move(seams)};
    group.place = placeOf(sides, garment_.stitches[group.seams.front()]);
    const PlaceTable& table = kPlaces[static_cast<std::size_t>(group.place)];
    const int facing = facingOf(sides);
    group.visibility = facing > 0 ? table.front : facing < 0 ? table.back : table.side;
    if (sides.a == sides.b) group.visibility = std::min(group.visibility, kOwnSeam);
    group.ends = endsOf(group.seams);
    if (group.place != SeamPlace::kCentreFront && group.place != SeamPlace::kCentreBack)
      group.side = sideOf(sides);
    return group;
  }

 private:
  /// Greatest visibility of a seam of one piece.
  static constexpr double kOwnSeam = 0.7;

  struct Sides {
    int a, b;             ///< pieces
    Vec3 at_a, at_b, at;  ///< means of both sides, and of all. [cm]
    double out_a, out_b;  ///< rise of the directions out of both pieces. [1]
  };

  /// The side of the seam and of its pieces: an implied arrangement may put an inseam beyond the
  /// middle.
  BodySide sideOf(const Sides& sides) const {
    const double x = sides.at.x() + worn_.middle[sides.a].x() + worn_.middle[sides.b].x();
    return x > kMiddle ? BodySide::kLeft : x < -kMiddle ? BodySide::kRight : BodySide::kMiddle;
  }

  /// Height as a share of the torso's.
  double heightOf(double y) const { return (y - lowest_) / std::max(1.0, highest_ - lowest_); }

  Vec3 sideMiddle(const SeamSide& side) const {
    Vec3 sum = Vec3::Zero();
    for (const int v : side.vertices) sum += worn_.at[side.piece][v];
    return sum / static_cast<double>(side.vertices.size());
  }

  /// Sum of the edges' outward normals, each as long as its edge. [cm]
  Vec2 outward(const SeamSide& side) const {
    const Piece& piece = worn_.sketch.pieces[side.piece];
    const int count = static_cast<int>(piece.outline.size());
    Vec2 out = Vec2::Zero();
    for (std::size_t k = 0; k + 1 < side.vertices.size(); ++k) {
      const int from = outlineEdge(piece, side.vertices[k], side.vertices[k + 1]);
      const Vec2 way = piece.rest[(from + 1) % count] - piece.rest[from];
      out += Vec2(way.y(), -way.x());
    }
    return out;
  }

  Sides sidesOf(const std::vector<int>& seams) const {
    const Seam& first = worn_.sketch.seams[seams.front()];
    Sides sides{first.a.piece, first.b.piece, Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), 0, 0};
    Vec2 out_a = Vec2::Zero(), out_b = Vec2::Zero();
    double length = 0;
    for (const int s : seams) {
      const Seam& seam = worn_.sketch.seams[s];
      const bool turned = seam.a.piece != sides.a;
      const SeamSide &a = turned ? seam.b : seam.a, &b = turned ? seam.a : seam.b;
      const EdgeRef& edge = garment_.stitches[s].a;
      const double weight = garment_.panels[edge.piece].edges[edge.edge].length();
      sides.at_a += weight * sideMiddle(a), sides.at_b += weight * sideMiddle(b);
      out_a += outward(a), out_b += outward(b);
      length += weight;
    }
    sides.at_a /= length, sides.at_b /= length;
    sides.at = (sides.at_a + sides.at_b) / 2;
    const auto rise = [&](int piece, const Vec2& out) {
      const double size = out.norm();
      return size > 0 ? worn_.up[piece].dot(out) / size : 0;
    };
    sides.out_a = rise(sides.a, out_a), sides.out_b = rise(sides.b, out_b);
    return sides;
  }

  /// 1 at the front, -1 at the back, 0 at the side or across.
  int facing(double z) const {
    const double ahead = z - worn_.middle_depth;
    return ahead > kAtSide * worn_.depth ? 1 : ahead < -kAtSide * worn_.depth ? -1 : 0;
  }

  int facingOf(const Sides& sides) const {
    const int a = facing(worn_.middle[sides.a].z()), b = facing(worn_.middle[sides.b].z());
    if (a * b != 0) return a == b ? a : 0;
    return facing(sides.at.z());
  }

  /// Returns whether a piece is long and narrow with blunt ends, and sewn along one of its long
  /// sides only. Both may be sewn below the yoke if the piece runs across the body, as a waistband
  /// between bodice and skirt does.
  bool isBand(int i) const {
    const Piece& piece = worn_.sketch.pieces[i];
    double area = 0, length = 0;
    Vec2 along = Vec2::UnitX();
    const std::size_t count = piece.rest.size(), step = 1 + count / kMostPoints;
    for (std::size_t k = 0; k < count; ++k)
      area += cross(piece.rest[k], piece.rest[(k + 1) % count]) / 2;
    for (std::size_t k = 0; k < count; k += step) {
      for (std::size_t m = k + step; m < count; m += step)
        if (const Vec2 way = piece.rest[m] - piece.rest[k]; way.norm() > length)
          length = way.norm(), along = way / length;
    }
    const double breadth = area / length;
    if (breadth > kWaistBreadth || length < kWaistLength * breadth) return false;
    double ends = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const Vec2 edge = piece.rest[(k + 1) % count] - piece.rest[k];
      if (std::abs(cross(along, edge)) > kAcross * edge.norm()) ends += edge.norm();
    }
    if (ends < kBluntEnds * breadth) return false;
    bool sewn[2] = {false, false};
    for (const Seam& seam : worn_.sketch.seams)
      for (const auto& [side, other] : {std::pair(&seam.a, &seam.b), {&seam.b, &seam.a}}) {
        if (side->piece != i || other->piece == i) continue;
        if (worn_.arm[i] != worn_.arm[other->piece]) return false;
        const Vec2 out = outward(*side);
        const double aside = cross(along, out);
        if (std::abs(aside) > kAcross * out.norm()) sewn[aside > 0] = true;
      }
    if (!(sewn[0] && sewn[1])) return breadth <= kBandBreadth && length >= kBandLength * breadth;
    return std::abs(worn_.up[i].dot(along)) < kLevel && heightOf(worn_.middle[i].y()) < kYokeHeight;
  }

  /// Returns whether a seam of front and back is nearer to the middle than both of its pieces.
  bool isInseam(const Sides& sides) const {
    if (sides.a == sides.b || worn_.arm[sides.a] || worn_.arm[sides.b]) return false;
    const double a = worn_.middle[sides.a].x(), b = worn_.middle[sides.b].x();
    return facing(worn_.middle[sides.a].z()) * facing(worn_.middle[sides.b].z()) < 0 && a * b > 0 &&
           std::abs(sides.out_a) < kAcross && std::abs(sides.out_b) < kAcross &&
           std::abs(sides.at.x()) < std::min(std::abs(a), std::abs(b)) - 1;
  }

  template <std::size_t N>
  bool isNamed(const Sides& sides, const std::array<std::string_view, N>& words) const {
    return isCalled(garment_.panels[sides.a].name, words) ||
           isCalled(garment_.panels[sides.b].name, words);
  }

  SeamPlace placeOf(const Sides& sides, const Stitch& first) const {
    const int a = sides.a, b = sides.b;
    if (isNamed(sides, kInsideWords)) return SeamPlace::kInside;
    if (isNamed(sides, kFacingWords)) return SeamPlace::kFacing;
    if (isNamed(sides, kPocketWords)) return SeamPlace::kPocket;
    if (a == b && neighbours(garment_.panels[a], first.a.edge, first.b.edge).adjacent)
      return SeamPlace::kDart;
    const bool banded = band_[a] || band_[b];
    if (worn_.arm[a] && worn_.arm[b]) return banded ? SeamPlace::kCuff : SeamPlace::kSleeve;
    if (worn_.neck[a] || worn_.neck[b]) return neckPlace(worn_.neck[a] ? a : b);
    if (worn_.arm[a] || worn_.arm[b])
      return facing((worn_.arm[a] ? sides.at_b : sides.at_a).z()) < 0 ? SeamPlace::kSleeveHeadBack
                                                                      : SeamPlace::kSleeveHeadFront;
    if (banded) return SeamPlace::kBand;
    return torsoPlace(sides);
  }

  SeamPlace neckPlace(int piece) const {
    double low = 1e9, high = -1e9;
    for (const Vec3& p : worn_.at[piece]) low = std::min(low, p.y()), high = std::max(high, p.y());
    return high - low > kHoodHeight ? SeamPlace::kHood : SeamPlace::kCollar;
  }

  SeamPlace torsoPlace(const Sides& sides) const {
    const double least = std::min(sides.out_a, sides.out_b);
    const double most = std::max(sides.out_a, sides.out_b);
    if (least > kAcross) return SeamPlace::kShoulder;
    if (legs_ && most < -kAcross) return SeamPlace::kCrotch;
    const int facing_seam = facingOf(sides);
    if (most > kAcross && least < -kAcross && sides.a != sides.b) {
      return heightOf(sides.at.y()) > kYokeHeight ? SeamPlace::kYoke : SeamPlace::kWaist;
    }
    // A seam that closes one piece around the body is opposite its middle.
    if (sides.a == sides.b)
      return facing(worn_.middle[sides.a].z()) > 0 ? SeamPlace::kCentreBack
                                                   : SeamPlace::kCentreFront;
    if (facing_seam == 0)
      return isInseam(sides) ? SeamPlace::kInseam : legs_ ? SeamPlace::kOutseam : SeamPlace::kSide;
    const double left = worn_.middle[sides.a].x() - sides.at.x();
    const double right = worn_.middle[sides.b].x() - sides.at.x();
    if (std::abs(sides.at.x()) > kMiddle || left * right > 0) return SeamPlace::kPrincess;
    return facing_seam > 0 ? SeamPlace::kCentreFront : SeamPlace::kCentreBack;
  }

  /// Names both ends of a group: before its first and after its last stitch along the outline.
  std::array<SeamEnd, 2> endsOf(const std::vector<int>& seams) const {
    const SeamSide& first = worn_.sketch.seams[seams.front()].a;
    const Seam& last_seam = worn_.sketch.seams[seams.back()];
    const SeamSide& last = last_seam.a.piece == first.piece ? last_seam.a : last_seam.b;
    const std::vector<Vec3>& at = worn_.at[first.piece];
    const Vec3 way = at[last.vertices.back()] - at[first.vertices.front()];
    const bool upright = std::abs(way.y()) > 0.5 * way.norm();
    if (upright)
      return way.y() > 0 ? std::array{SeamEnd::kBottom, SeamEnd::kTop}
                         : std::array{SeamEnd::kTop, SeamEnd::kBottom};
    return way.x() > 0 ? std::array{SeamEnd::kRight, SeamEnd::kLeft}
                       : std::array{SeamEnd::kLeft, SeamEnd::kRight};
  }

  const Garment& garment_;
  WornLayout worn_;
  std::vector<char> band_;
  double lowest_ = 1e9, highest_ = -1e9;
  bool legs_ = false;
};

bool samePieces(const Stitch& s, const Stitch& t) {
  return std::minmax(s.a.piece, s.b.piece) == std::minmax(t.a.piece, t.b.piece);
}

/// Returns whether two stitches of the same pieces follow each other in one line: on one of two
/// pieces, or on both sides of a dart.
bool areConsecutive(const Garment& garment, const Stitch& s, const Stitch& t) {
  const bool turned = s.a.piece != t.a.piece;
  const auto along = [&](const EdgeRef& one, const EdgeRef& other) {
    return neighbours(garment.panels[one.piece], one.edge, other.edge);
  };
  const Neighbours a = along(s.a, turned ? t.b : t.a), b = along(s.b, turned ? t.a : t.b);
  if (s.a.piece != s.b.piece) return (a.adjacent && a.smooth) || (b.adjacent && b.smooth);
  const Neighbours crossed = along(s.a, t.b), other = along(s.b, t.a);
  return (a.adjacent && b.adjacent && (a.smooth || b.smooth)) ||
         (crossed.adjacent && other.adjacent && (crossed.smooth || other.smooth));
}

/// Sorts stitches along the outline of a piece, from the widest gap on.
void sortAlong(const Garment& garment, std::vector<int>* seams) {
  const int piece = garment.stitches[seams->front()].a.piece;
  const int count = static_cast<int>(garment.panels[piece].edges.size());
  const auto edge = [&](int s) {
    const Stitch& stitch = garment.stitches[s];
    return stitch.a.piece == piece ? stitch.a.edge : stitch.b.edge;
  };
  std::sort(seams->begin(), seams->end(), [&](int s, int t) { return edge(s) < edge(t); });
  std::size_t first = 0;
  int widest = 0;
  for (std::size_t k = 0; k < seams->size(); ++k) {
    const int before = edge((*seams)[(k + seams->size() - 1) % seams->size()]);
    const int gap = (edge((*seams)[k]) - before + count) % count;
    if (gap > widest) widest = gap, first = k;
  }
  std::rotate(seams->begin(), seams->begin() + static_cast<std::ptrdiff_t>(first), seams->end());
}

}  // namespace

const char* placeName(SeamPlace place) { return kPlaces[static_cast<std::size_t>(place)].name; }

std::vector<SeamGroup> seamGroups(const Garment& garment, const std::vector<BodySymmetry>& known) {
  const auto& stitches = garment.stitches;
  const int count = static_cast<int>(stitches.size());
  std::vector<SeamGroup> groups;
  if (stitches.size() > kMostStitches) {
    for (int s = 0; s < count; ++s) groups.push_back({{s}, SeamPlace::kOther, kPlaces[0].side});
    return groups;
  }
  if (stitches.empty()) return groups;
  DisjointSets sets(count);
  for (int s = 0; s < count; ++s)
    for (int t = s + 1; t < count; ++t)
      if (samePieces(stitches[s], stitches[t]) && areConsecutive(garment, stitches[s], stitches[t]))
        sets.join(s, t);
  const Grouping grouping(garment, known);
  for (int s = 0; s < count; ++s) {
    if (sets.find(s) != s) continue;
    std::vector<int> seams;
    for (int t = s; t < count; ++t)
      if (sets.find(t) == s) seams.push_back(t);
    sortAlong(garment, &seams);
    groups.push_back(grouping.place(std::move(seams)));
  }
  return groups;
}

void weighByVisibility(const std::vector<SeamGroup>& groups, Garment* garment,
                       std::vector<MatchLine>* matches) {
  for (MatchLine& match : *matches)
    if (match.weight == 1) match.weight = kMatchedLineWeight;
  const auto length = [&](const EdgeRef& edge) {
    return garment->panels[edge.piece].edges[edge.edge].length();
  };
  for (const SeamGroup& group : groups)
    for (const int s : group.seams) {
      Stitch& stitch = garment->stitches[s];
      stitch.visibility = group.visibility;
      if (stitch.weight != 1) continue;
      const double ratio = length(stitch.a) / length(stitch.b);
      const bool gathered = ratio > kEased || ratio < 1 / kEased;
      stitch.weight = gathered ? kGatheredWeight : group.visibility;
    }
}

}  // namespace seamwise
