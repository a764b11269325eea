#include "drape/settle.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "drape/vectors.h"
#include "drape/weld.h"

namespace seamwise {
namespace {

// Maximum asymmetry of a garment that is meant to be symmetric. [cm]
constexpr double kSymmetric = 6;

// Weight of an edge that is too short in a round; one that is too long has 1/2. [1]
constexpr double kShortening = 0.1;
// Minimum distance of trouser legs from the middle. [cm]
constexpr double kLegsApart = 0.2;

class Settling {
 public:
  Settling(const Pattern& pattern, const Form& form, const Hanging& hanging,
           const std::vector<char>& on_top, const std::vector<std::vector<double>>& outward,
           const std::vector<std::vector<char>>& covered, const WrapSettings& settings)
      : pattern_(pattern),
        form_(form),
        order_(hanging.order),
        settings_(settings),
        in_pleats_(covered),
        covered_(hanging.covered()),
        weld_(welded(pattern, hanging.order)) {
    for (const Mirror& mirror : pattern.mirrors)
      if (on_top[mirror.pieces[0]] != on_top[mirror.pieces[1]]) layered_alike_ = false;
    const std::size_t count = weld_.members.size();
    parts_.assign(count, 0), legs_.assign(count, 0), clearance_.assign(count, settings.clearance);
    for (int p : order_)
      for (std::size_t v = 0; v < weld_.knot[p].size(); ++v) {
        const int knot = weld_.knot[p][v];
        parts_[knot] |= touching(hanging.parts[p]);
        if (only(hanging.parts[p]) & kLegs) legs_[knot] |= only(hanging.parts[p]);
        if (outward[p][v] > 0 || weld_.members[knot].size() == 1)
          clearance_[knot] = settings.clearance + outward[p][v];
      }
    sewn_to_ = parts_;
    for (int p : order_)
      if (hanging.parts[p] == BodyPart::kTorso)
        for (int knot : weld_.knot[p]) parts_[knot] &= ~kArms;
  }

  void run(PiecePositions* positions) {
    for (const auto& members : weld_.members) {
      Vec3 sum = Vec3::Zero();
      for (const Weld::Member& m : members) sum += (*positions)[m.piece][m.vertex];
      x_.push_back(sum / static_cast<double>(members.size()));
    }
    symmetric_ = !weld_.image.empty() && layered_alike_ && asymmetry() < kSymmetric;
    push();
    for (int round = 0; round < settings_.rounds; ++round) {
      // Upper arms come later, because an armhole first has to find its side of the arm.
      if (round == settings_.rounds / 2) meetUpperArms();
      drawEdges();
      push();
    }
    for (int p : order_)
      for (std::size_t v = 0; v < weld_.knot[p].size(); ++v)
        (*positions)[p][v] = x_[weld_.knot[p][v]];
  }

 private:
  // Returns the parts of the form that push a piece out. Skirts hang past arms, and bodices past
  // forearms.
  BodyParts touching(BodyPart part) const {
    const BodyParts own = only(part) | kTorsoAndNeck;
    if (part == BodyPart::kTorso) return own | (covered_ & kLegs);
    if (only(part) & kLegs) return own | kLegs;
    return part == BodyPart::kNeck ? own | (covered_ & only(BodyPart::kHead)) : own;
  }

  // Makes shoulders and upper arms push bodices out as well; forearms do not.
  void meetUpperArms() {
    parts_ = sewn_to_;
    const double chest = form_.measures().waist_height + 0.4 * form_.measures().back_length;
    for (std::size_t k = 0; k < x_.size(); ++k)
      if (x_[k].y() > chest) parts_[k] |= covered_ & kArms;
  }

  // Mean distance of a vertex from the mirror image of its image. [cm]
  double asymmetry() const {
    double sum = 0;
    for (std::size_t k = 0; k < x_.size(); ++k)
      sum += length(Vec3(x_[k] - mirrored(x_[weld_.image[k]])));
    return sum / static_cast<double>(x_.size());
  }

  void symmetrise() {
    if (!symmetric_) return;
    for (std::size_t k = 0; k < x_.size(); ++k) {
      const std::size_t image = weld_.image[k];
      if (image < k) continue;
      const Vec3 mean = (x_[k] + mirrored(x_[image])) / 2;
      x_[k] = mean;
      x_[image] = image == k ? Vec3(0, mean.y(), mean.z()) : mirrored(mean);
    }
  }

  // Runs one Jacobi round on the lengths of all edges.
  void drawEdges() {
    std::vector<Vec3> move(x_.size(), Vec3::Zero());
    std::vector<int> count(x_.size(), 0);
    for (int p : order_)
      for (const std::array<int, 3>& triangle : pattern_.pieces[p].triangles)
        for (int e = 0; e < 3; ++e) {
          const int u = triangle[e], v = triangle[(e + 1) % 3];
          if (in_pleats_[p][u] || in_pleats_[p][v]) continue;
          const int a = weld_.knot[p][u], b = weld_.knot[p][v];
          const double rest =
              planarLength(Vec2(pattern_.pieces[p].rest[v] - pattern_.pieces[p].rest[u]));
          const Vec3 edge = x_[b] - x_[a];
          const double now = length(edge);
          ++count[a], ++count[b];
          if (now < 1e-9) continue;
          // Cloth may be gathered but not stretched.
          const double share = now > rest ? 0.5 : kShortening;
          const Vec3 half = edge * ((now - rest) / now * share);
          move[a] += half, move[b] -= half;
        }
    for (std::size_t k = 0; k < x_.size(); ++k)
      if (count[k] > 0) x_[k] += move[k] * (1.6 / count[k]);
  }

  void push() {
    for (std::size_t k = 0; k < x_.size(); ++k) {
      if (legs_[k] == only(BodyPart::kLeftLeg)) x_[k].x() = std::max(x_[k].x(), kLegsApart);
      if (legs_[k] == only(BodyPart::kRightLeg)) x_[k].x() = std::min(x_[k].x(), -kLegsApart);
      // Distances are exact only to first order, so deep vertices take a few steps.
      for (int step = 0; step < 8; ++step) {
        Vec3 slope;
        const double missing = clearance_[k] - form_.distance(x_[k], parts_[k], &slope);
        if (missing <= 1e-6) break;
        const double steep = dot(slope, slope);
        if (steep < 1e-6) break;
        x_[k] += slope * (missing / steep);
      }
    }
    symmetrise();
  }

  const Pattern& pattern_;
  const Form& form_;
  const std::vector<int>& order_;
  const WrapSettings& settings_;
  const std::vector<std::vector<char>>& in_pleats_;
  BodyParts covered_;
  const Weld weld_;
  std::vector<BodyParts> parts_;    ///< per sewn vertex: parts that push it out
  std::vector<BodyParts> sewn_to_;  ///< per sewn vertex: the same, with the sleeves' arms
  std::vector<BodyParts> legs_;     ///< per sewn vertex: trouser legs that contain it
  std::vector<double> clearance_;   ///< per sewn vertex, cm
  std::vector<Vec3> x_;             ///< per sewn vertex, cm
  bool layered_alike_ = true;       ///< mirror twins have equally many layers below them
  bool symmetric_ = false;
};

}  // namespace

void settle(const Pattern& pattern, const Form& form, const Hanging& hanging,
            const std::vector<char>& on_top, const std::vector<std::vector<double>>& outward,
            const std::vector<std::vector<char>>& covered, const WrapSettings& settings,
            PiecePositions* positions) {
  Settling(pattern, form, hanging, on_top, outward, covered, settings).run(positions);
}

}  // namespace seamwise
