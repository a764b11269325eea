#include "drape/wrap.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "drape/layers.h"
#include "drape/pleat_layers.h"
#include "drape/pleats.h"
#include "drape/ring.h"
#include "drape/settle.h"
#include "drape/turn.h"
#include "drape/weld.h"

namespace seamwise {
namespace {

// Levels between which trousers blend from the legs' rings to the torso's, relative to the crotch.
// [cm]
constexpr double kLegBelow = -3, kTorsoAbove = 8;
// Weight of a piece's own placement relative to heights that seams agree on. [1]
constexpr double kOwnHeight = 0.02;
// Ease of a band over the body where it starts, and the maximum lift to get it. [cm]
constexpr double kBandEase = 2.5, kMostLift = 8;
// Girth of a strap relative to the neck. [1]
constexpr double kStrapEase = 1.06;
// Minimum cosine to the vertical of trouser legs drawn for legs apart.
constexpr double kNearlyUpright = 0.9;
// Girth of a ring with pleats relative to the body, and the largest share to which pleats open. [1]
constexpr double kPleatEase = 1.04, kMostOpen = 0.8;
// Height of uneven hems at the ends of pieces. [cm]
constexpr int kHem = 6, kCuff = 1;

bool isLeg(BodyPart part) { return only(part) & kLegs; }
bool isArm(BodyPart part) { return only(part) & kArms; }

class Wrapper {
 public:
  Wrapper(const Pattern& pattern, const Form& form, const Hanging& hanging,
          const std::vector<char>& on_top, const WrapSettings& settings,
          const std::vector<std::vector<Pleat>>& pleats = {})
      : pattern_(pattern),
        form_(form),
        hanging_(hanging),
        on_top_(on_top),
        settings_(settings),
        pleats_(pleats) {}

  PiecePositions run() {
    layOut();
    findStraps();
    agreeOnHeights();
    liftToWaist();
    PiecePositions positions(pattern_.pieces.size());
    outward_.resize(positions.size()), opened_.resize(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
      positions[i].resize(pattern_.pieces[i].rest.size());
      outward_[i].assign(pattern_.pieces[i].rest.size(), on_top_[i] ? settings_.layer : 0);
    }
    windAll(&positions);
    hangStraps(&positions);
    return positions;
  }

  double fullness() const { return fullness_; }
  /// Returns per piece and vertex the distance outwards of the ring. [cm]
  const std::vector<std::vector<double>>& outward() const { return outward_; }
  PleatLayers pleatLayers() const {
    PleatLayers layers(pattern_);
    for (std::size_t i = 0; i < upright_.size(); ++i)
      if (!upright_[i].empty()) layers.add(static_cast<int>(i), flat_[i], upright_[i], opened_[i]);
    return layers;
  }

  std::vector<WornGirth> girths(BodyPart part) {
    layOut();
    findStraps();
    agreeOnHeights();
    const std::optional<Ring> ring = ringOf(part);
    if (!ring) return {};
    std::vector<WornGirth> girths;
    for (const auto& [level, width] : ring->closedWidths(isArm(part) ? kCuff : kHem))
      girths.push_back({level + base(part), width});
    return girths;
  }

  std::optional<double> rise() {
    layOut();
    findStraps();
    agreeOnHeights();
    double top = -1e9, crotch = 1e9;
    const auto height = [&](int piece, int v) {
      return flat_[piece][v].y() + base(hanging_.parts[piece]);
    };
    for (int i : hanging_.order)
      for (int v : pattern_.pieces[i].outline)
        if (hanging_.parts[i] == BodyPart::kTorso || isLeg(hanging_.parts[i]))
          top = std::max(top, height(i, v));
    for (const Seam& seam : pattern_.seams)
      if ((only(hanging_.parts[seam.a.piece]) | only(hanging_.parts[seam.b.piece])) == kLegs)
        for (int v : seam.a.vertices) crotch = std::min(crotch, height(seam.a.piece, v));
    return crotch < top ? std::optional(top - crotch) : std::nullopt;
  }

 private:
  const Axis& axisOf(int piece) const { return form_.tube(hanging_.parts[piece]).axis(); }
  // Height of level 0 of the part's tube; levels of arms have their own origin.
  double base(BodyPart part) const { return isArm(part) ? 0 : form_.tube(part).axis().origin.y(); }

  // Flattens pieces to (across, level) along the axis of their part.
  void layOut() {
    for (std::size_t i = 0; i < pattern_.pieces.size(); ++i) {
      const PlacedPiece& placed = hanging_.placed[i];
      const Piece& piece = pattern_.pieces[i];
      const Axis& axis = axisOf(static_cast<int>(i));
      Vec2 middle = Vec2::Zero();
      for (int v : piece.outline) middle += piece.rest[v];
      middle /= static_cast<double>(piece.outline.size());
      Vec2 up(dot(placed.right, axis.up), dot(placed.up, axis.up));
      double level = axis.local(placed(middle)).z();
      if (isArm(hanging_.parts[i]) && std::abs(placed.up.y()) > 0.99) {
        // The sleeve is drawn for an arm held out to the side.
        const double side = hanging_.parts[i] == BodyPart::kLeftArm ? 1 : -1;
        up = {-side * placed.right.x(), 0};
        level = form_.shoulderPoint().x() - side * placed(middle).x();
      }
      // The trousers are drawn for legs apart, but the form's legs are vertical.
      if (isLeg(hanging_.parts[i]) && up.y() > kNearlyUpright) up = {0, 1};
      const double length_up = planarLength(up);
      up = length_up > 0.5 ? Vec2(up / length_up) : Vec2(0, 1);
      const auto upright = [&](const Vec2& p) -> Vec2 {
        const Vec2 q = p - middle;
        return {up.y() * q.x() - up.x() * q.y(), level + up.x() * q.x() + up.y() * q.y()};
      };
      std::vector<Vec2> flat;
      for (const Vec2& p : piece.rest) flat.push_back(upright(p));
      flat_.push_back(std::move(flat));
      upright_.emplace_back();
      if (pleats_.empty()) continue;
      for (const Pleat& pleat : pleats_[i])
        if (const auto one = uprightPleat(pleat, upright)) upright_[i].push_back(*one);
      sortAcross(upright_[i]);
    }
  }

  // Finds straps: pieces behind the neck of which only the ends are sewn, to pieces on the torso.
  void findStraps() {
    straps_.assign(pattern_.pieces.size(), false);
    std::vector<char> sewn_along(straps_);
    for (const Seam& seam : pattern_.seams)
      for (const auto& [own, other] : {std::pair(&seam.a, &seam.b), {&seam.b, &seam.a}}) {
        if (hanging_.parts[own->piece] != BodyPart::kNeck) continue;
        const std::vector<Vec2>& flat = flat_[own->piece];
        const Vec2 along = flat[own->vertices.back()] - flat[own->vertices.front()];
        const bool end = std::abs(along.y()) > std::abs(along.x()) &&
                         hanging_.parts[other->piece] == BodyPart::kTorso;
        (end ? straps_ : sewn_along)[own->piece] = true;
      }
    for (std::size_t p = 0; p < straps_.size(); ++p) straps_[p] = straps_[p] && !sewn_along[p];
  }

  // Returns the distance from its middle at which a strap leaves the side of the neck. [cm]
  double strapOver() const {
    return kStrapEase * form_.tube(BodyPart::kNeck).section(0).girth() / 4;
  }

  // Runs straps straight from the sides of the neck to their sewn ends.
  void hangStraps(PiecePositions* positions) const {
    for (const Seam& seam : pattern_.seams)
      for (const auto& [own, other] : {std::pair(&seam.a, &seam.b), {&seam.b, &seam.a}}) {
        if (!straps_[own->piece]) continue;
        const std::vector<Vec2>& flat = flat_[own->piece];
        const Vec2 first = flat[own->vertices.front()], last = flat[own->vertices.back()];
        const Vec3 &at_first = (*positions)[other->piece][other->vertices.front()],
                   &at_last = (*positions)[other->piece][other->vertices.back()];
        const double end = (first.x() + last.x()) / 2, side = end < 0 ? -1 : 1, over = strapOver();
        for (std::size_t v = 0; v < flat.size(); ++v) {
          const double share = (side * flat[v].x() - over) / (side * end - over);
          if (!(share > 0 && side * end > over)) continue;
          const double across = (flat[v].y() - first.y()) / (last.y() - first.y());
          Vec3& at = (*positions)[own->piece][v];
          at = at * (1 - share) + (at_first * (1 - across) + at_last * across) * share;
        }
      }
  }

  // Moves pieces along their axes until both sides of seams have about equal heights, by
  // Gauss-Seidel. Files hang bands, collars and cuffs at a distance.
  void agreeOnHeights() {
    struct Tie {
      int other;
      double lower;  ///< depth of the other piece below this one, summed over vertices
      double count;
    };
    std::vector<std::vector<Tie>> ties(pattern_.pieces.size());
    for (const Seam& seam : pattern_.seams) {
      const int a = seam.a.piece, b = seam.b.piece;
      const BodyPart on_a = hanging_.parts[a], on_b = hanging_.parts[b];
      if (a == b || ((isArm(on_a) || isArm(on_b)) && on_a != on_b)) continue;
      if (straps_[a] || straps_[b]) continue;
      double sum = 0;
      for (std::size_t i = 0; i < seam.a.vertices.size(); ++i)
        sum += (flat_[a][seam.a.vertices[i]].y() + base(on_a)) -
               (flat_[b][seam.b.vertices[i]].y() + base(on_b));
      const double count = static_cast<double>(seam.a.vertices.size());
      ties[a].push_back({b, sum, count});
      ties[b].push_back({a, -sum, count});
    }
    std::vector<double> shift(pattern_.pieces.size(), 0.0);
    for (int round = 0; round < 200; ++round)
      for (int i : hanging_.order) {
        double pull = 0, weight = kOwnHeight * static_cast<double>(pattern_.pieces[i].rest.size());
        for (const Tie& tie : ties[i]) {
          pull += tie.count * shift[tie.other] - tie.lower;
          weight += tie.count;
        }
        shift[i] = pull / weight;
      }
    for (std::size_t i = 0; i < flat_.size(); ++i) lift(static_cast<int>(i), shift[i]);
  }

  void lift(int piece, double by) {
    for (Vec2& p : flat_[piece]) p.y() += by;
    for (UprightPleat& pleat : upright_[piece])
      for (Crease* line : {&pleat.left, &pleat.right})
        for (Vec2& end : *line) end.y() += by;
  }

  // Lifts a garment that hangs from the waist, by at most kMostLift, to where its band fits.
  // Friction would hold it where it is too tight.
  void liftToWaist() {
    if (!hangsFromWaist(hanging_, pattern_, form_)) return;
    const Tube& torso = form_.tube(BodyPart::kTorso);
    const std::optional<Ring> ring = ringOf(BodyPart::kTorso);
    if (!ring) return;
    const std::vector<std::pair<double, double>> widths = ring->closedWidths(kHem);
    const auto missing = [&](double more) {
      double most = 0;
      for (const auto& [level, width] : widths)
        most = std::max(most, torso.section(level + more).girth() + kBandEase - width);
      return most;
    };
    double most = 0, least = missing(0);
    for (double more = 0.5; more <= kMostLift && least > 0; more += 0.5)
      if (const double now = missing(more); now < least) least = now, most = more;
    for (int i : hanging_.order) lift(i, most);
  }

  // Share of their width to which the pleats of a ring are open, at levels 1 cm apart.
  struct Opening {
    double bottom = 0;
    std::vector<double> shares;
    double at(double level) const {
      if (shares.empty()) return 0;
      const double k = std::clamp(level - bottom, 0.0, static_cast<double>(shares.size() - 1));
      const auto below = static_cast<std::size_t>(k);
      const double share = k - static_cast<double>(below);
      const std::size_t above = std::min(below + 1, shares.size() - 1);
      return shares[below] * (1 - share) + shares[above] * share;
    }
  };

  // Returns the pieces of a part, the legs' ones with the torso's, in the frame of its ring. Pleats
  // are flat without an opening.
  std::vector<RingPiece> ringPieces(BodyPart part, const Opening* opening) const {
    const Tube& tube = form_.tube(part);
    std::vector<RingPiece> pieces;
    for (int i : hanging_.order) {
      const BodyPart own = hanging_.parts[i];
      if (own != part && !(part == BodyPart::kTorso && isLeg(own))) continue;
      RingPiece piece;
      piece.piece = i;
      piece.outline = &pattern_.pieces[i];
      piece.flat = flat_[i];
      for (Vec2& p : piece.flat) {
        if (opening) p.x() = closedAt(upright_[i], p, opening->at(p.y())).across;
        p.y() += base(own) - base(part);
        if (straps_[i]) p.x() = std::clamp(p.x(), -strapOver(), strapOver());
      }
      const Vec3 middle = tube.axis().local(hanging_.middles[i]);
      piece.angle = degreesBetween(middle.y() - tube.section(middle.z()).middle, middle.x());
      pieces.push_back(std::move(piece));
    }
    return pieces;
  }

  // Returns the ring around one part with flat pleats.
  std::optional<Ring> ringOf(BodyPart part) const { return ringWith(part, nullptr); }

  std::optional<Ring> ringWith(BodyPart part, const Opening* opening) const {
    std::vector<RingPiece> pieces = ringPieces(part, opening);
    if (pieces.empty()) return std::nullopt;
    // Sleeves and trouser legs are too narrow, and therefore too stiff, for waves.
    const double fold = part == BodyPart::kTorso ? settings_.fold : 0;
    return Ring(form_.tube(part), pattern_, std::move(pieces), fold);
  }

  // Returns how far pleats open so that a ring has room for the body. Below the widest part of the
  // body they remain as open as there.
  Opening openingOf(BodyPart part) const {
    Opening opening;
    const Opening closed;
    const std::optional<Ring> ring = ringWith(part, &closed);
    if (!ring) return opening;
    const auto widths = ring->closedWidths(0);
    if (widths.empty()) return opening;
    const Tube& tube = form_.tube(part);
    opening.bottom = widths.front().first;
    opening.shares.assign(static_cast<std::size_t>(widths.back().first - opening.bottom) + 1, 0);
    double missing = 0;
    for (std::size_t k = widths.size(); k-- > 0;) {
      const auto& [level, width] = widths[k];
      missing = std::max(missing, kPleatEase * tube.section(level).girth() - width);
      double room = 0;
      for (const RingPiece& piece : ring->pieces())
        for (const UprightPleat& pleat : upright_[piece.piece])
          if (pleat.opens() && piece.reaches(level)) room += pleat.widthAt(level);
      if (room > 0)
        opening.shares[static_cast<std::size_t>(level - opening.bottom)] =
            std::min(kMostOpen, missing / room);
    }
    return opening;
  }

  void windAll(PiecePositions* positions) {
    for (int p = 0; p < kBodyParts; ++p) {
      const auto part = static_cast<BodyPart>(p);
      const Opening opening = pleats_.empty() ? Opening() : openingOf(part);
      const std::optional<Ring> ring = ringWith(part, pleats_.empty() ? nullptr : &opening);
      if (!ring) continue;
      fullness_ = std::max(fullness_, ring->fullness());
      for (std::size_t k = 0; k < ring->pieces().size(); ++k) {
        const RingPiece& piece = ring->pieces()[k];
        for (std::size_t v = 0; v < piece.flat.size(); ++v) {
          double& outward = outward_[piece.piece][v];
          if (hanging_.parts[piece.piece] == part && !upright_[piece.piece].empty()) {
            const Vec2& flat = flat_[piece.piece][v];
            opened_[piece.piece].push_back(opening.at(flat.y()));
            outward +=
                kPleatLayer * closedAt(upright_[piece.piece], flat, opening.at(flat.y())).layer;
          }
          blend(&(*positions)[piece.piece][v], part, piece, static_cast<int>(v),
                ring->position(static_cast<int>(k), static_cast<int>(v), outward));
        }
      }
    }
  }

  // Blends a leg's ring into the torso's ring, which comes first.
  void blend(Vec3* position, BodyPart part, const RingPiece& piece, int vertex,
             const Vec3& found) const {
    double share = 1;
    if (isLeg(part)) {
      const double t =
          std::clamp((piece.flat[vertex].y() - kLegBelow) / (kTorsoAbove - kLegBelow), 0.0, 1.0);
      share = 1 - t * t * (3 - 2 * t);
    }
    *position = share == 1 ? found : Vec3(*position * (1 - share) + found * share);
  }

  const Pattern& pattern_;
  const Form& form_;
  const Hanging& hanging_;
  const std::vector<char>& on_top_;  ///< per piece: covers another one
  const WrapSettings& settings_;
  std::vector<std::vector<Vec2>> flat_;             ///< per piece, per vertex: (across, level)
  std::vector<char> straps_;                        ///< per piece
  const std::vector<std::vector<Pleat>> pleats_;    ///< per piece; or empty
  std::vector<std::vector<UprightPleat>> upright_;  ///< per piece: pleats in the frame of `flat_`
  std::vector<std::vector<double>> outward_;        ///< per piece, per vertex, cm
  std::vector<std::vector<double>> opened_;         ///< per piece with pleats, per vertex
  double fullness_ = 0;
};

}  // namespace

Outcome<PiecePositions> wrapped(const Garment& garment, const Pattern& pattern, const Form& form,
                                const WrapSettings& settings, double* fullness) {
  const Outcome<Hanging> hanging = hang(garment, pattern, form);
  if (!hanging.ok()) return hanging.error();
  const std::vector<Overlap> overlaps = overlapsOf(garment, pattern, hanging.value());
  std::vector<char> on_top(pattern.pieces.size(), false);
  for (const Overlap& overlap : overlaps) on_top[overlap.upper] = true;
  Wrapper wrapper(pattern, form, hanging.value(), on_top, settings, pleatsOf(garment, pattern));
  PiecePositions positions = wrapper.run();
  if (fullness) *fullness = wrapper.fullness();
  const PleatLayers layers = wrapper.pleatLayers();
  settle(pattern, form, hanging.value(), on_top, wrapper.outward(), layers.covered(), settings,
         &positions);
  layers.lay(&positions);
  layOnOthers(garment, pattern, overlaps, settings.layer, &positions);
  return positions;
}

std::vector<WornGirth> wornGirths(const Garment& garment, const Pattern& pattern, const Form& form,
                                  BodyPart part) {
  const Outcome<Hanging> hanging = hang(garment, pattern, form);
  if (!hanging.ok()) return {};
  const std::vector<char> on_top(pattern.pieces.size(), false);
  return Wrapper(pattern, form, hanging.value(), on_top, {}).girths(part);
}

std::optional<double> wornRise(const Garment& garment, const Pattern& pattern, const Form& form) {
  const Outcome<Hanging> hanging = hang(garment, pattern, form);
  if (!hanging.ok()) return std::nullopt;
  const std::vector<char> on_top(pattern.pieces.size(), false);
  return Wrapper(pattern, form, hanging.value(), on_top, {}).rise();
}

}  // namespace seamwise
