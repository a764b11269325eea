#include <algorithm>
#include <cstdio>
#include <optional>

#include "geometry/in_quotes.h"
#include "symmetry/detection.h"
#include "symmetry/symmetry.h"

namespace seamwise {
namespace {

constexpr double kClickTurn = 5 * kPi / 180;  // a clicked axis may be off by this much,
constexpr double kClickShift = 1.0;           // and by this much at the middle of the clicks, cm
constexpr double kEdgesMeet = 2 * kMirrorTolerance;

std::string centimetres(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

Error doesNotMirror(const std::string& what, double residual, const std::string& remedy,
                    int piece) {
  return {Failure::kSymmetryDoesNotMirror,
          what + ": the mirrored outline lies up to " + centimetres(residual) + " cm off (limit " +
              centimetres(kMirrorTolerance) + " cm); " + remedy,
          piece};
}

Error malformed(const std::string& message, int piece) {
  return {Failure::kSymmetryMalformed, message, piece};
}

// The direction of a reflection's axis differs by half the angle between the motions.
double axisTurn(const RigidMotion& x, const RigidMotion& y) {
  return std::abs(wrapAngle(x.angle - y.angle)) / 2;
}

class Registrar {
 public:
  explicit Registrar(const Garment& garment) : garment_(garment) {}

  Outcome<BodySymmetry> operator()(const AxisRequest& request) {
    const int piece = garment_.find(request.piece);
    const Panel& panel = garment_.panels[piece];
    Vec2 from = request.from, to = request.to;
    if (panel.mirrored_from_input) {
      from.x() = -from.x();
      to.x() = -to.x();
    }
    if (!from.allFinite() || !to.allFinite() || (to - from).norm() < kMirrorTolerance)
      return malformed(
          "the axis of piece " + inQuotes(panel.name) + " needs two different points; click it again",
          piece);
    const Outline outline(panel);
    const RigidMotion clicked = RigidMotion::reflection(from, to);
    const Vec2 middle = (from + to) / 2;
    const double as_clicked = mirrorResidual(outline, outline, clicked, 1e3);
    // ICP from the click first: a round piece has mirrors everywhere, and the click means just one.
    // The piece's own mirrors help where ICP was led astray, the bare click where it ran away.
    std::vector<MirrorFit> fits = findMirrors(outline, outline);
    fits.insert(fits.begin(), refineMirror(outline, outline, clicked));
    fits.push_back({clicked, as_clicked});
    const MirrorFit* best = nullptr;
    for (const MirrorFit& fit : fits) {
      const bool near = axisTurn(fit.map, clicked) <= kClickTurn &&
                        (fit.map(middle) - middle).norm() / 2 <= kClickShift;
      if (near && fit.residual <= kMirrorTolerance &&
          (!best || fit.residual + 2 * Outline::kFlatness < best->residual))
        best = &fit;
    }
    if (!best)
      return doesNotMirror("piece " + inQuotes(panel.name) + " does not mirror across the given axis",
                           as_clicked, "move the axis, or choose two edges that mirror each other",
                           piece);
    return bodySymmetry(garment_, piece, piece, *best);
  }

  Outcome<BodySymmetry> operator()(const EdgesRequest& request) {
    const int piece = garment_.find(request.piece);
    const Panel& panel = garment_.panels[piece];
    const int count = static_cast<int>(panel.edges.size());
    for (const int edge : {request.first, request.second})
      if (edge < 0 || edge >= count)
        return malformed("piece " + inQuotes(panel.name) + " has no edge " + std::to_string(edge) +
                             "; its edges are 0 to " + std::to_string(count - 1),
                         piece);
    if (request.first == request.second)
      return malformed("edge " + std::to_string(request.first) + " of piece " + inQuotes(panel.name) +
                           " is named twice; name two edges that mirror each other",
                       piece);
    const Curve &first = panel.edges[request.first], &second = panel.edges[request.second];
    const Outline outline(panel);
    const MirrorFit registered = refineMirror(outline, outline, registerEdges(first, second));
    // Where the two edges alone leave a freedom (straight edges of unequal length slide along each
    // other), the piece's own mirrors are asked which of them carries one edge to the other.
    std::vector<MirrorFit> fits = findMirrors(outline, outline);
    fits.insert(fits.begin(), registered);
    const MirrorFit* best = nullptr;
    double least = kEdgesMeet;
    for (const MirrorFit& fit : fits) {
      const double apart = edgeResidual(first, second, fit.map);
      if (fit.residual > kMirrorTolerance || apart > least - (best ? Outline::kFlatness : 0))
        continue;
      best = &fit;
      least = apart;
    }
    if (best) return bodySymmetry(garment_, piece, piece, *best);
    const std::string edges = "edges " + std::to_string(request.first) + " and " +
                              std::to_string(request.second) + " of piece " + inQuotes(panel.name);
    const RigidMotion across = registerEdges(first, second);
    return doesNotMirror(edges + " do not mirror onto each other with the whole piece",
                         std::max(mirrorResidual(outline, outline, across, 1e3),
                                  edgeResidual(first, second, across)),
                         "choose two other edges, or leave the piece free", piece);
  }

  Outcome<BodySymmetry> operator()(const PieceRequest& request) {
    const int piece = garment_.find(request.piece);
    return between(piece, piece, "piece " + inQuotes(request.piece) + " is not symmetric in itself",
                   "leave it free, or name its partner");
  }

  Outcome<BodySymmetry> operator()(const PairRequest& request) {
    return between(garment_.find(request.first), garment_.find(request.second),
                   "pieces " + inQuotes(request.first) + " and " + inQuotes(request.second) +
                       " are not mirror images",
                   "choose another pair");
  }

 private:
  Outcome<BodySymmetry> between(int from, int to, const std::string& complaint,
                                const std::string& remedy) {
    if (!maps_) maps_.emplace(garment_);
    std::vector<int> candidates;
    for (const int m : maps_->mapsFrom(from))
      if (maps_->maps()[m].to == to) candidates.push_back(m);
    const int chosen = likeliestMap(*maps_, candidates);
    if (chosen >= 0) return bodySymmetry(garment_, from, to, maps_->maps()[chosen].fit);
    const MirrorFit best = bestMirror(maps_->outline(from), maps_->outline(to));
    if (best.residual <= kMirrorTolerance) return bodySymmetry(garment_, from, to, best);
    return doesNotMirror(complaint, best.residual, remedy, from);
  }

  const Garment& garment_;
  std::optional<SeamMaps> maps_;  // costs a comparison of all pieces, so only when asked
};

struct PieceNames {
  std::vector<std::string> operator()(const PairRequest& r) const { return {r.first, r.second}; }
  template <class Single>
  std::vector<std::string> operator()(const Single& r) const {
    return {r.piece};
  }
};

}  // namespace

Outcome<std::vector<BodySymmetry>> registerSymmetries(
    const Garment& garment, const std::vector<SymmetryRequest>& requests) {
  std::vector<char> taken(garment.panels.size(), 0);
  for (const SymmetryRequest& request : requests)
    for (const std::string& name : std::visit(PieceNames{}, request)) {
      const int piece = garment.find(name);
      if (piece < 0)
        return Error{Failure::kSymmetryUnknownPiece,
                     "a symmetry names piece " + inQuotes(name) +
                         ", which the garment does not have; check its spelling"};
      if (taken[piece])
        return Error{Failure::kSymmetryConflict,
                     "piece " + inQuotes(name) + " is named twice in the symmetries; keep one",
                     piece};
      taken[piece] = 1;
    }
  Registrar registrar(garment);
  std::vector<BodySymmetry> found;
  for (const SymmetryRequest& request : requests) {
    Outcome<BodySymmetry> symmetry = std::visit(registrar, request);
    if (!symmetry.ok()) return symmetry.error();
    found.push_back(symmetry.value());
  }
  return found;
}

std::string namesOf(const Garment& garment, const BodySymmetry& symmetry) {
  const std::string first = inQuotes(garment.panels[symmetry.pieces[0]].name);
  return symmetry.single() ? first
                           : first + " and " + inQuotes(garment.panels[symmetry.pieces[1]].name);
}

}  // namespace seamwise
