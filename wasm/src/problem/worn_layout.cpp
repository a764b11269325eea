#include "problem/worn_layout.h"

#include <algorithm>
#include <cmath>

#include "base/disjoint_sets.h"
#include "drape/flat_layout.h"
#include "drape/piece_words.h"
#include "drape/seam_arms.h"
#include "symmetry/placement.h"

namespace seamwise {
namespace {

constexpr int kSteps = 8;  ///< of each edge
/// Height over the shoulders of the middle of a collar or hood. [cm]
constexpr double kOverShoulders = 1;
/// Least difference of the top edges of front and back that decides which is which. [cm]
constexpr double kLowerTop = 1;
/// Least distance between the pieces of front and back. [cm]
constexpr double kOneSided = 8;
/// Breadth around an axis at which the top edges of front and back are compared. [cm]
constexpr double kNearAxis = 4;
/// Share of a direction that points down where a piece ends below. [1]
constexpr double kBelow = 0.7;
/// Greatest area of a part of an arm, over that of the largest other part. [1]
constexpr double kSmallPart = 0.3;

Pattern sketchOf(const Garment& garment) {
  Pattern sketch;
  for (const Panel& panel : garment.panels) {
    Piece piece;
    piece.name = panel.name;
    for (const Curve& edge : panel.edges) {
      piece.edge_start.push_back(static_cast<int>(piece.rest.size()));
      for (int k = 0; k < kSteps; ++k) piece.rest.push_back(edge.at(double(k) / kSteps));
    }
    for (std::size_t v = 0; v < piece.rest.size(); ++v)
      piece.outline.push_back(static_cast<int>(v));
    sketch.pieces.push_back(std::move(piece));
  }
  const auto side = [&](const EdgeRef& edge, bool backwards) {
    const Piece& piece = sketch.pieces[edge.piece];
    SeamSide vertices{edge.piece, {}};
    for (int k = 0; k <= kSteps; ++k)
      vertices.vertices.push_back((piece.edge_start[edge.edge] + k) %
                                  static_cast<int>(piece.outline.size()));
    if (backwards) std::reverse(vertices.vertices.begin(), vertices.vertices.end());
    return vertices;
  };
  for (const Stitch& stitch : garment.stitches)
    sketch.seams.push_back({side(stitch.a, false), side(stitch.b, !stitch.same_direction)});
  return sketch;
}

/// The pieces side by side along their seams, wound around the body.
class WoundPieces {
 public:
  WoundPieces(const Garment& garment, const std::vector<BodySymmetry>& known, WornLayout* worn)
      : layout_(garment, worn->sketch), known_(known), worn_(worn) {
    const auto ring = layout_.ring([&](int i) { return layout_.isTorso(i); });
    girth_ = std::max(ring.girth, 1.0);
    axis_ = ring.across.middle();
    axis_ = frontAxis();
  }

  void place() {
    for (int i = 0; i < layout_.count(); ++i) {
      worn_->neck[i] = layout_.isNeck(i);
      worn_->up.push_back(layout_.upright().up(i));
      for (const int v : layout_.outline(i)) {
        const Vec2 p = layout_.laid(i, v);
        const double turn = 2 * kPi * (p.x() - axis_) / girth_, radius = girth_ / (2 * kPi);
        worn_->at[i].push_back({radius * std::sin(turn), p.y(), radius * std::cos(turn)});
      }
    }
  }

 private:
  /// An axis of the garment, or the opposite one: where the top edge is lower, else by names.
  double frontAxis() const {
    double axis = axis_;
    for (const BodySymmetry& symmetry : known_) {
      const int a = symmetry.pieces[0], b = symmetry.pieces[1];
      if (!layout_.isTorso(a) || !layout_.isTorso(b)) continue;
      if (symmetry.single()) axis = layout_.middle(a).x();
      for (const UprightJoin& join : layout_.upright().joins())
        if (!symmetry.single() && join.isUpright() &&
            std::minmax(join.a.piece, join.b.piece) == std::minmax(a, b))
          axis = layout_.at(join.a.piece).x() + join.a.middle.x();
    }
    double facing = 0, top[2] = {-1e9, -1e9};
    for (int i = 0; i < layout_.count(); ++i) {
      if (!layout_.isTorso(i)) continue;
      const double ahead = std::cos(2 * kPi * (layout_.middle(i).x() - axis) / girth_);
      if (isCalled(layout_.name(i), kFrontWords)) facing += ahead;
      if (isCalled(layout_.name(i), kBackWords)) facing -= ahead;
      for (const int v : layout_.outline(i)) {
        const Vec2 p = layout_.laid(i, v);
        const double halves = 2 * (p.x() - axis) / girth_, nearest = std::round(halves);
        double& highest = top[static_cast<int>(std::abs(nearest)) % 2];
        if (std::abs(halves - nearest) * girth_ < 2 * kNearAxis) highest = std::max(highest, p.y());
      }
    }
    if (std::abs(top[1] - top[0]) > kLowerTop) facing = top[1] - top[0];
    return facing < 0 ? axis + girth_ / 2 : axis;
  }

  FlatLayout layout_;
  const std::vector<BodySymmetry>& known_;
  WornLayout* worn_;
  double girth_ = 0, axis_ = 0;
};

/// Pieces of arms: those that the seams imply, but not tubes at the lower edges of other pieces, as
/// cuffs of trousers are. Small parts that are sewn to arms alone belong to them.
std::vector<char> armPieces(const Pattern& sketch, const UprightPieces& upright) {
  const int count = static_cast<int>(sketch.pieces.size());
  const std::vector<int> tubes = armsBySeams(sketch, upright);
  std::vector<Vec2> out(count, Vec2::Zero());
  for (const UprightJoin& join : upright.joins())
    for (const auto& [arm, other] : {std::pair(&join.a, &join.b), {&join.b, &join.a}})
      if (const int tube = tubes[arm->piece]; tube >= 0 && tubes[other->piece] < 0)
        out[tube] += join.length * other->out;
  std::vector<char> arms(count, 0);
  for (int i = 0; i < count; ++i)
    if (tubes[i] >= 0) arms[i] = out[tubes[i]].y() >= -kBelow * out[tubes[i]].norm();
  DisjointSets parts(count);
  for (const UprightJoin& join : upright.joins())
    if (!arms[join.a.piece] && !arms[join.b.piece]) parts.join(join.a.piece, join.b.piece);
  std::vector<double> area(count, 0);
  for (int i = 0; i < count; ++i)
    if (!arms[i]) area[parts.find(i)] += upright.area(i);
  const double largest = *std::max_element(area.begin(), area.end());
  std::vector<char> follows(count, 0);
  for (const UprightJoin& join : upright.joins())
    for (const auto& [arm, other] :
         {std::pair(join.a.piece, join.b.piece), {join.b.piece, join.a.piece}})
      if (arms[arm] && !arms[other]) follows[parts.find(other)] = 1;
  for (int i = 0; i < count; ++i)
    if (const int part = parts.find(i); !arms[i] && follows[part])
      arms[i] = area[part] < kSmallPart * largest;
  return arms;
}

/// Finds pieces over the shoulders: over seams that join the upper edges of pieces, and over the
/// tops of sleeves.
void findNeck(const UprightPieces& upright, WornLayout* worn) {
  double shoulders = -1e9;
  for (const Seam& seam : worn->sketch.seams) {
    const UprightJoin& join = upright.joins()[&seam - worn->sketch.seams.data()];
    if (!join.isShoulder() && worn->arm[seam.a.piece] == worn->arm[seam.b.piece]) continue;
    const SeamSide& side = worn->arm[seam.a.piece] ? seam.b : seam.a;
    for (const int v : side.vertices) shoulders = std::max(shoulders, worn->at[side.piece][v].y());
  }
  if (shoulders < -1e8) return;
  for (std::size_t i = 0; i < worn->at.size(); ++i)
    worn->neck[i] = !worn->arm[i] && worn->middle[i].y() > shoulders + kOverShoulders;
}

}  // namespace

WornLayout wornLayout(const Garment& garment, const std::vector<BodySymmetry>& known) {
  const std::size_t count = garment.panels.size();
  WornLayout worn;
  worn.sketch = sketchOf(garment);
  worn.at.resize(count), worn.neck.assign(count, 0);
  const UprightPieces upright(garment, worn.sketch);
  if (count > 0) worn.arm = armPieces(worn.sketch, upright);
  const Placement placement(garment);
  if (placement.known()) {
    for (std::size_t i = 0; i < count; ++i) {
      const int piece = static_cast<int>(i);
      const Vec3 origin = placement.placed(piece, Vec2::Zero());
      worn.up.emplace_back((placement.placed(piece, Vec2::UnitX()) - origin).y(),
                           (placement.placed(piece, Vec2::UnitY()) - origin).y());
      for (const Vec2& p : worn.sketch.pieces[i].rest)
        worn.at[i].push_back(placement.placed(piece, p));
    }
  } else {
    WoundPieces(garment, known, &worn).place();
  }
  double back = 1e9, front = -1e9;
  for (std::size_t i = 0; i < count; ++i) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& p : worn.at[i]) sum += p;
    worn.middle.push_back(sum / std::max<double>(1, static_cast<double>(worn.at[i].size())));
    if (worn.arm[i]) continue;
    back = std::min(back, worn.middle[i].z()), front = std::max(front, worn.middle[i].z());
  }
  if (placement.known()) findNeck(upright, &worn);
  // A garment that covers one side of the body covers its front, unless it is placed behind.
  if (front - back < kOneSided) {
    if (front < -kOneSided)
      front = kOneSided;
    else
      back -= 2 * kOneSided;
  }
  worn.middle_depth = (front + back) / 2;
  worn.depth = (front - back) / 2;
  return worn;
}

}  // namespace seamwise
