#include "drape/parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/disjoint_sets.h"
#include "base/in_quotes.h"
#include "base/sort_by.h"
#include "drape/placed_by_seams.h"
#include "drape/turn.h"

namespace seamwise {
namespace {

// Maximum height over the waist of a garment that hangs from the waist, as a share of the back
// length. [1]
constexpr double kBelowChest = 0.4;

// Height of the origin over the floor in Garment-Pattern-Generator's files. [cm]
constexpr double kMiddleOverFloor = 112.07;
// Minimum height of garments placed over the floor. [cm]
constexpr double kBelowFloor = -20;
// Maximum distance of worn pieces from the floor's middle. [cm]
constexpr double kFarthest = 400;

// Returns the placement of a panel: turns about the fixed axes x, then y, then z, as in
// symmetry/placement.h, but with the same bits on all platforms.
PlacedPiece placedPiece(const Panel& panel) {
  const auto turned = [&](Vec3 v) {
    const Turn x = turnOfDegrees(degreesOf(panel.placement_turn.x()));
    const Turn y = turnOfDegrees(degreesOf(panel.placement_turn.y()));
    const Turn z = turnOfDegrees(degreesOf(panel.placement_turn.z()));
    v = {v.x(), x.cosine * v.y() - x.sine * v.z(), x.sine * v.y() + x.cosine * v.z()};
    v = {y.cosine * v.x() + y.sine * v.z(), v.y(), y.cosine * v.z() - y.sine * v.x()};
    return Vec3(z.cosine * v.x() - z.sine * v.y(), z.sine * v.x() + z.cosine * v.y(), v.z());
  };
  const Vec3 right = turned(Vec3(panel.mirrored_from_input ? -1 : 1, 0, 0));
  return {right, turned(Vec3::UnitY()), panel.placement_shift};
}

// Returns the distance of a point from the axis of a tube between its ends. [cm]
double distanceToAxis(const Tube& tube, const Vec3& p) {
  const Vec3 q = tube.axis().local(p);
  const double beyond = q.z() - std::clamp(q.z(), tube.bottom(), tube.top());
  return std::sqrt(q.x() * q.x() + q.y() * q.y() + beyond * beyond);
}

class Hanger {
 public:
  Hanger(const Garment& garment, const Pattern& pattern, const Form& form)
      : garment_(garment), pattern_(pattern), form_(form) {}

  Outcome<Hanging> run() {
    if (std::optional<Error> error = place()) return *error;
    const std::vector<char> legs = ofLegs();
    for (std::size_t i = 0; i < pattern_.pieces.size(); ++i)
      hanging_.parts.push_back(partOf(static_cast<int>(i), legs[i]));
    if (!hanging_.by_seams) {
      lowerArms();
      raiseHood();
    }
    for (std::size_t i = 0; i < pattern_.pieces.size(); ++i)
      hanging_.order.push_back(static_cast<int>(i));
    // The last sort decides: order by height, then depth, then side.
    for (const int axis : {0, 2, 1})
      sortBy(hanging_.order, [&](int piece) { return hanging_.middles[piece][axis]; });
    return std::move(hanging_);
  }

 private:
  std::optional<Error> place() {
    bool same = true;
    double lowest = 1e9;
    for (std::size_t i = 0; i < garment_.panels.size(); ++i) {
      const Panel& panel = garment_.panels[i];
      for (const Vec3& v : {panel.placement_shift, panel.placement_turn})
        if (!(v.cwiseAbs().maxCoeff() < 1e9))
          return Error{
              Failure::kNumber,
              "Piece " + inQuotes(panel.name) + " is placed at something that is no number.",
              static_cast<int>(i)};
      const Panel& first = garment_.panels.front();
      same = same && panel.placement_shift == first.placement_shift &&
             panel.placement_turn == first.placement_turn;
      hanging_.placed.push_back(placedPiece(panel));
      for (int v : pattern_.pieces[i].outline)
        lowest = std::min(lowest, hanging_.placed[i](pattern_.pieces[i].rest[v]).y());
    }
    if (same) {
      Outcome<PlacedPieces> found = placedBySeams(garment_, pattern_, form_);
      if (!found.ok()) return found.error();
      hanging_.by_seams = true;
      hanging_.held = found.value().held;
      hanging_.placed = std::move(found.value().placed);
      of_seams_ = std::move(found.value().parts);
      // measuresFor() in worn_garment.cpp moves the garment to the form's height by adding a lift
      // to all placements.
      const double lift = garment_.panels.front().placement_shift.y();
      for (PlacedPiece& placed : hanging_.placed) placed.shift.y() += lift;
      lowest = 0;
    }
    for (std::size_t i = 0; i < garment_.panels.size(); ++i) {
      const Piece& piece = pattern_.pieces[i];
      if (lowest < kBelowFloor) hanging_.placed[i].shift.y() += kMiddleOverFloor;
      Vec3 sum = Vec3::Zero();
      for (int v : piece.outline) sum += hanging_.placed[i](piece.rest[v]);
      hanging_.middles.push_back(sum / static_cast<double>(piece.outline.size()));
      if (hanging_.middles[i].cwiseAbs().maxCoeff() > kFarthest)
        return Error{Failure::kNotAGarment,
                     "Piece " + inQuotes(piece.name) +
                         " is placed far from any body: give 'translation' in the units of the "
                         "garment's file, from the floor up, and align it again.",
                     static_cast<int>(i), -1, "drapeFar"};
    }
    return std::nullopt;
  }

  double height(int piece, int vertex) const {
    return hanging_.placed[piece](pattern_.pieces[piece].rest[vertex]).y();
  }

  // Returns per piece whether its seams below the crotch lead only to pieces of the same side.
  std::vector<char> ofLegs() const {
    // Some files hang trousers lower. Pieces of one side are then sewn to each other twice, at the
    // inseam and the outseam.
    std::vector<char> legs = ofLegsBelow(8, 1);
    for (double drop = 16; drop < 36; drop += 8)
      if (std::count(legs.begin(), legs.end(), true) == 0) legs = ofLegsBelow(drop, 2);
    return legs;
  }

  std::vector<char> ofLegsBelow(double drop, int seams) const {
    const int count = static_cast<int>(pattern_.pieces.size());
    const double below = form_.crotchHeight() - drop;
    std::vector<char> legs(count, false), low(count, false);
    DisjointSets sewn(count);
    std::vector<int> joins(count, 0);
    for (const Seam& seam : pattern_.seams) {
      bool joined = false;
      for (std::size_t i = 0; i < seam.a.vertices.size(); ++i)
        if (height(seam.a.piece, seam.a.vertices[i]) < below &&
            height(seam.b.piece, seam.b.vertices[i]) < below) {
          low[seam.a.piece] = low[seam.b.piece] = joined = true;
          sewn.join(seam.a.piece, seam.b.piece);
        }
      if (joined) ++joins[seam.a.piece], ++joins[seam.b.piece];
    }
    // Per set: number of its pieces on the right, in the middle and on the left.
    std::vector<std::array<int, 3>> sides(count, {0, 0, 0});
    const auto sideOf = [&](int i) {
      const double x = hanging_.middles[i].x();
      return x < -4 ? 0 : x > 4 ? 2 : 1;
    };
    for (int i = 0; i < count; ++i)
      if (low[i]) ++sides[sewn.find(i)][sideOf(i)];
    bool left = false, right = false;
    for (int i = 0; i < count; ++i) {
      const auto& [on_right, in_middle, on_left] = sides[sewn.find(i)];
      legs[i] = low[i] && joins[i] >= seams && in_middle == 0 && (on_right == 0 || on_left == 0);
      left = left || (legs[i] && on_left > 0);
      right = right || (legs[i] && on_right > 0);
    }
    if (!left || !right) legs.assign(count, false);
    return legs;
  }

  BodyPart partOf(int i, bool leg) const {
    const bool left = hanging_.middles[i].x() > 0;
    if (leg) return left ? BodyPart::kLeftLeg : BodyPart::kRightLeg;
    if (hanging_.by_seams && (only(of_seams_[i]) & (kArms | only(BodyPart::kTorso))))
      return of_seams_[i];
    double lowest = 1e9, highest = -1e9, to_arm = 0, to_torso = 0;
    const BodyPart arm = left ? BodyPart::kLeftArm : BodyPart::kRightArm;
    const Piece& piece = pattern_.pieces[i];
    for (int v : piece.outline) {
      const Vec3 p = hanging_.placed[i](piece.rest[v]);
      lowest = std::min(lowest, p.y()), highest = std::max(highest, p.y());
      to_arm += distanceToAxis(form_.tube(arm), p);
      to_torso += distanceToAxis(form_.tube(BodyPart::kTorso), p);
    }
    // Pieces above the shoulders belong to the neck or, if tall, to the head. Hoods reach down to
    // the front of the neck.
    const double over_shoulder = lowest - form_.shoulderPoint().y();
    const double over_nape = highest - form_.napeHeight();
    if (over_shoulder > 3) return over_nape > 26 ? BodyPart::kHead : BodyPart::kNeck;
    if (over_shoulder > -12 && over_nape > 20) return BodyPart::kHead;
    // A piece of an arm is tilted like the arm; other pieces may be equally close to it. [cm]
    const double tilt = std::abs(hanging_.placed[i].up.y());
    const double bias = tilt < 0.95 ? -15 : 15;
    const double nearer = (to_arm - to_torso) / static_cast<double>(piece.outline.size());
    return nearer + bias < 0 ? arm : BodyPart::kTorso;
  }

  // Moves arm pieces below the chest to the torso. Sleeves reach up to the chest, together with the
  // arm pieces sewn to them; other tilted pieces are gores.
  void lowerArms() {
    const int count = static_cast<int>(hanging_.parts.size());
    DisjointSets sewn(count);
    const auto isArm = [&](int i) { return (only(hanging_.parts[i]) & kArms) != 0; };
    for (const Seam& seam : pattern_.seams)
      if (isArm(seam.a.piece) && isArm(seam.b.piece)) sewn.join(seam.a.piece, seam.b.piece);
    std::vector<double> top(count, -1e9);
    for (int i = 0; i < count; ++i)
      for (int v : pattern_.pieces[i].outline)
        top[sewn.find(i)] = std::max(top[sewn.find(i)], height(i, v));
    const double chest = form_.measures().waist_height + 0.4 * form_.measures().back_length;
    for (int i = 0; i < count; ++i)
      if (isArm(i) && top[sewn.find(i)] < chest) hanging_.parts[i] = BodyPart::kTorso;
  }

  // Assigns neck pieces to the head if they are sewn to a piece of the head.
  void raiseHood() {
    for (std::size_t round = 0; round < hanging_.parts.size(); ++round) {
      bool changed = false;
      for (const Seam& seam : pattern_.seams) {
        BodyPart &a = hanging_.parts[seam.a.piece], &b = hanging_.parts[seam.b.piece];
        if (a == BodyPart::kHead && b == BodyPart::kNeck) b = a, changed = true;
        if (b == BodyPart::kHead && a == BodyPart::kNeck) a = b, changed = true;
      }
      if (!changed) break;
    }
  }

  const Garment& garment_;
  const Pattern& pattern_;
  const Form& form_;
  Hanging hanging_;
  std::vector<BodyPart> of_seams_;  ///< per piece: part given by seams
};

}  // namespace

BodyParts Hanging::covered() const {
  BodyParts all = kTorsoAndNeck;
  for (BodyPart part : parts) all |= only(part);
  return all;
}

Outcome<Hanging> hang(const Garment& garment, const Pattern& pattern, const Form& form) {
  return Hanger(garment, pattern, form).run();
}

bool hangsFromWaist(const Hanging& hanging, const Pattern& pattern, const Form& form) {
  const double chest = form.measures().waist_height + kBelowChest * form.measures().back_length;
  for (const int i : hanging.order) {
    if (hanging.parts[i] != BodyPart::kTorso && !(only(hanging.parts[i]) & kLegs)) return false;
    for (const int v : pattern.pieces[i].outline)
      if (hanging.placed[i](pattern.pieces[i].rest[v]).y() > chest) return false;
  }
  return true;
}

}  // namespace seamwise
