#include "drape/placed_by_seams.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "base/in_quotes.h"
#include "drape/flat_layout.h"
#include "drape/piece_words.h"
#include "drape/turn.h"
#include "drape/vectors.h"

namespace seamwise {
namespace {

// Distance of pieces from the middle of the body or the arm before they are wound around it. [cm]
constexpr double kAway = 23, kAwayFromArm = 10;
// Height of a collar over the shoulders. [cm]
constexpr double kCollar = 4;
// Height of the shoulders' neck ends over the nape. [cm]
constexpr double kOverNape = 2.5;
// Height over the waist of a waistband's top edge, and of a top edge without waistband, as in the
// sample patterns. [cm]
constexpr double kBandOverWaist = 3.5, kTopOverWaist = 2.2;
// Minimum sum of the unit vectors to front pieces, or away from shoulders, that gives a direction.
constexpr double kLeastFacing = 0.5;

class SeamPlacer {
 public:
  SeamPlacer(const Garment& garment, const Pattern& pattern, const Form& form)
      : pattern_(pattern), form_(form), layout_(garment, pattern) {}

  Outcome<PlacedPieces> run() {
    if (const int alone = layout_.unjoined(); alone >= 0)
      return Error{Failure::kNotAGarment,
                   "No seam joins piece " + inQuotes(layout_.name(alone)) +
                       " to the others, and the file does not say where it hangs: sew it, or give "
                       "the panels of the garment a 'translation' each.",
                   alone, -1, "drapeUnsewn"};
    wind();
    PlacedPieces all;
    all.held = held_;
    for (int i = 0; i < layout_.count(); ++i) {
      all.placed.push_back(armOf(i) < 0 ? aboutTorso(i) : PlacedPiece{});
      all.parts.push_back(layout_.isNeck(i) ? BodyPart::kNeck : BodyPart::kTorso);
    }
    for (int i = 0; i < layout_.count(); ++i)
      if (armOf(i) >= 0) all.parts[i] = hangArm(i, &all.placed);
    return all;
  }

 private:
  const std::vector<UprightJoin>& joins() const { return layout_.upright().joins(); }
  int armOf(int i) const { return layout_.arm()[i]; }

  // Finds the torso's girth, the position of the front's axis, and the height of the layout.
  void wind() {
    const auto [across, girth] = layout_.ring([&](int i) { return layout_.isTorso(i); });
    girth_ = girth;
    double top = -1e9, band = -1e9;
    for (int i = 0; i < layout_.count(); ++i) {
      if (!layout_.isTorso(i)) continue;
      top = std::max(top, layout_.topOf(i));
      if (isCalled(layout_.name(i), kBandWords)) band = std::max(band, layout_.topOf(i));
    }
    const bool from_neck = layout_.hasShoulders();
    held_ = from_neck ? form_.napeHeight() : form_.measures().waist_height;
    lift_ = held_ + (from_neck     ? kOverNape - top
                     : band > -1e8 ? kBandOverWaist - band
                                   : kTopOverWaist - top);
    axis_ = frontAxis(across.middle());
    around_neck_ = layout_.ring([&](int i) { return layout_.isNeck(i); }).across;
  }

  // Returns the middle of the front in the layout. It is on an axis of the garment or opposite one.
  // Piece names decide between the two, otherwise the top edge, which is lowest or open in front.
  double frontAxis(double otherwise) const {
    const std::vector<Vec2> axes = axesOfMirrors();
    if (axes.empty()) return axisByNames().value_or(axisByShoulders().value_or(otherwise));
    double best = axes.front().x(), most = -1e9;
    for (const Vec2& axis : axes)
      for (const double far : {0.0, girth_ / 2}) {
        double score = 0;
        for (int i = 0; i < layout_.count(); ++i)
          if (layout_.isTorso(i) && facing(i) != 0)
            score += facing(i) * turnFrom(axis.x() + far, layout_.middle(i).x()).cosine;
        // The top edge counts less than any name.
        score -= 1e-6 * (far == 0 ? axis.y() - axes.front().y() : -1);
        if (score > most + 1e-9) most = score, best = axis.x() + far;
      }
    return best;
  }

  std::vector<Vec2> axesOfMirrors() const {
    std::vector<Vec2> axes;
    for (const Mirror& mirror : pattern_.mirrors) {
      const int a = mirror.pieces[0], b = mirror.pieces[1];
      if (layout_.isTorso(a) && mirror.single()) axes.push_back(topOfAxis(mirror));
      for (const UprightJoin& join : joins())
        if (layout_.isTorso(a) && layout_.isTorso(b) && join.isUpright() &&
            std::minmax(join.a.piece, join.b.piece) == std::minmax(a, b) && a != b)
          axes.push_back(layout_.at(join.a.piece) + Vec2(join.a.middle.x(), join.a.top));
    }
    return axes;
  }

  // Returns the direction of the pieces with names of the front, away from those of the back.
  std::optional<double> axisByNames() const {
    Vec2 sum(0, 0);
    for (int i = 0; i < layout_.count(); ++i) {
      if (!layout_.isTorso(i)) continue;
      const Turn turn = turnFrom(0, layout_.middle(i).x());
      sum += facing(i) * Vec2(turn.cosine, turn.sine);
    }
    if (sum.norm() < kLeastFacing) return std::nullopt;
    return degreesBetween(sum.x(), sum.y()) / 360 * girth_;
  }

  // Returns the direction at right angles to both shoulders: the front or the back.
  std::optional<double> axisByShoulders() const {
    Vec2 sum(0, 0);
    for (const UprightJoin& join : joins()) {
      if (!join.isShoulder()) continue;
      for (const UprightSide* side : {&join.a, &join.b}) {
        if (!layout_.isTorso(side->piece)) continue;
        // Twice the angle is equal for both shoulders.
        const Turn turn = turnFrom(0, 2 * (layout_.at(side->piece).x() + side->middle.x()));
        sum -= Vec2(turn.cosine, turn.sine);
      }
    }
    if (sum.norm() < kLeastFacing) return std::nullopt;
    return degreesBetween(sum.x(), sum.y()) / 720 * girth_;
  }

  // Returns 1 for names of the front, -1 for names of the back, and 0 for others.
  double facing(int i) const {
    return isCalled(layout_.name(i), kFrontWords)  ? 1
           : isCalled(layout_.name(i), kBackWords) ? -1
                                                   : 0;
  }

  // Returns the turn around the body between two positions across the layout.
  Turn turnFrom(double axis, double across) const {
    return turnOfDegrees(360 * (across - axis) / girth_);
  }

  // Returns the upper end of a piece's own axis, in layout coordinates.
  Vec2 topOfAxis(const Mirror& mirror) const {
    const int i = mirror.pieces[0];
    double across = 0, nearest = 1e9;
    for (std::size_t v = 0; v < mirror.image.size(); ++v)
      across +=
          (layout_.laid(i, static_cast<int>(v)).x() + layout_.laid(i, mirror.image[v]).x()) / 2;
    Vec2 found(across / static_cast<double>(mirror.image.size()), 0);
    const double middle = layout_.middle(i).y();
    for (const int v : layout_.outline(i)) {
      const Vec2 p = layout_.laid(i, v);
      if (p.y() > middle && std::abs(p.x() - found.x()) < nearest)
        nearest = std::abs(p.x() - found.x()), found.y() = p.y();
    }
    return found;
  }

  // Places a piece with its middle at `place` and its across and up directions along two unit
  // vectors.
  PlacedPiece placedAt(int i, const Vec3& place, const Vec3& right, const Vec3& up) const {
    const Vec2& u = layout_.upright().up(i);
    PlacedPiece placed{right * u.y() + up * u.x(), up * u.y() - right * u.x(), Vec3::Zero()};
    placed.shift = place - placed(layout_.middleOf(i));
    return placed;
  }

  PlacedPiece aboutTorso(int i) const {
    const Vec2 middle = layout_.middle(i);
    double height = middle.y() + lift_, degrees = 360 * (middle.x() - axis_) / girth_;
    if (layout_.isNeck(i)) {
      // The middle of a collar or hood is at the back.
      degrees = 180 + 300 * (middle.x() - around_neck_.middle()) / around_neck_.width();
      Breadth own;
      for (const int v : layout_.outline(i)) own.add(layout_.laid(i, v).y());
      height += std::max(0.0, form_.shoulderPoint().y() + kCollar - own.low - lift_);
    }
    const Turn turn = turnOfDegrees(degrees);
    return placedAt(i, {kAway * turn.sine, height, kAway * turn.cosine},
                    {turn.cosine, 0, -turn.sine}, Vec3::UnitY());
  }

  // Sums over the vertices that join an arm's layout to the torso.
  struct Armhole {
    double count = 0;
    double side = 0;    ///< x on the torso: left is positive
    double level = 0;   ///< position on the torso along the arm: y - |x|
    double height = 0;  ///< height in the layout
    /// Positions across the layout, and vertex counts: behind, in front.
    double ahead[2] = {0, 0}, number[2] = {0, 0};
    double girth = 0;
  };

  Armhole armholeOf(int arm, const std::vector<PlacedPiece>& placed) const {
    Armhole hole;
    for (const Seam& seam : pattern_.seams)
      for (const auto& [one, other] : {std::pair(&seam.a, &seam.b), {&seam.b, &seam.a}}) {
        if (armOf(one->piece) != arm || armOf(other->piece) >= 0) continue;
        for (std::size_t v = 0; v < one->vertices.size(); ++v) {
          const Vec3 p =
              placed[other->piece](pattern_.pieces[other->piece].rest[other->vertices[v]]);
          const Vec2 q = layout_.laid(one->piece, one->vertices[v]);
          hole.count += 1, hole.side += p.x(), hole.level += p.y() - std::abs(p.x());
          hole.height += q.y();
          hole.ahead[p.z() > 0] += q.x(), hole.number[p.z() > 0] += 1;
        }
      }
    hole.girth = layout_.ring([&](int i) { return armOf(i) == arm; }).girth;
    return hole;
  }

  // Hangs a sleeve's piece along the arm on whose side it is sewn to the torso. Its mean height
  // along the arm at the armhole is that of the torso, and its seam with the front points ahead.
  BodyPart hangArm(int i, std::vector<PlacedPiece>* placed) const {
    const Armhole hole = armholeOf(armOf(i), *placed);
    const bool left = hole.side > 0;
    const double s = std::sqrt(0.5), sign = left ? 1 : -1, count = std::max(1.0, hole.count);
    const Vec3 shoulder = form_.shoulderPoint();
    const Vec3 up(-sign * s, s, 0), out(sign * s, s, 0);
    const Vec2 middle = layout_.middle(i);
    const double below = s * (hole.level / count - (shoulder.y() - shoulder.x()));
    const double along = below + middle.y() - hole.height / count;
    double outermost = middle.x();
    if (hole.number[0] > 0 && hole.number[1] > 0) {
      const double behind = hole.ahead[0] / hole.number[0], ahead = hole.ahead[1] / hole.number[1];
      // The front is on the left of a left sleeve seen from outside.
      outermost = (behind + ahead) / 2 + (sign * (behind - ahead) < 0 ? hole.girth / 2 : 0);
    }
    const Turn turn = turnOfDegrees(-sign * 360 * (middle.x() - outermost) / hole.girth);
    const Vec3 outwards = out * turn.cosine + Vec3::UnitZ() * turn.sine;
    (*placed)[i] = placedAt(
        i, Vec3(sign * shoulder.x(), shoulder.y(), 0) + up * along + outwards * kAwayFromArm,
        crossProduct(up, outwards), up);
    return left ? BodyPart::kLeftArm : BodyPart::kRightArm;
  }

  const Pattern& pattern_;
  const Form& form_;
  FlatLayout layout_;
  Breadth around_neck_;
  double girth_ = 0, axis_ = 0, held_ = 0, lift_ = 0;  ///< cm
};

}  // namespace

Outcome<PlacedPieces> placedBySeams(const Garment& garment, const Pattern& pattern,
                                    const Form& form) {
  return SeamPlacer(garment, pattern, form).run();
}

}  // namespace seamwise
