#include <algorithm>
#include <optional>

#include "base/decimal.h"
#include "base/in_quotes.h"
#include "symmetry/detection.h"
#include "symmetry/symmetry.h"
#include "tuning/symmetry.h"

namespace seamwise {
namespace {

std::string centimetres(double value) { return fixed(value, 2); }

/// The result of a request, and the parts of the message if it does not mirror.
struct Registered {
  MeasuredSymmetry measured;
  std::string complaint, remedy;
};

Error doesNotMirror(const Registered& registered) {
  const BodySymmetry& symmetry = registered.measured.symmetry;
  return {Failure::kSymmetryDoesNotMirror,
          registered.complaint + ": the mirrored outline lies up to " +
              centimetres(symmetry.residual) + " cm off (limit " + centimetres(kMirrorTolerance) +
              " cm); " + registered.remedy,
          symmetry.pieces[0]};
}

Error malformed(const std::string& message, int piece) {
  return {Failure::kSymmetryMalformed, message, piece};
}

// Angle between the axes of two reflections: half the angle between the motions.
double axisTurn(const RigidMotion& x, const RigidMotion& y) {
  return std::abs(wrapAngle(x.angle - y.angle)) / 2;
}

class Registrar {
 public:
  explicit Registrar(const Garment& garment) : garment_(garment) {}

  Outcome<Registered> operator()(const AxisRequest& request) {
    const int piece = garment_.find(request.piece);
    const Panel& panel = garment_.panels[piece];
    Vec2 from = request.from, to = request.to;
    if (panel.mirrored_from_input) {
      from.x() = -from.x();
      to.x() = -to.x();
    }
    if (!from.allFinite() || !to.allFinite() || (to - from).norm() < kMirrorTolerance)
      return malformed("the axis of piece " + inQuotes(panel.name) +
                           " needs two different points; click it again",
                       piece);
    const Outline outline(panel);
    const RigidMotion clicked = RigidMotion::reflection(from, to);
    const Vec2 middle = (from + to) / 2;
    // ICP from the click comes first, because a round piece has mirrors everywhere and the click
    // selects one. The piece's own mirrors help if ICP finds another axis, the bare click if ICP
    // diverges.
    std::vector<MirrorRegistration> candidates = findMirrors(outline, outline);
    candidates.insert(candidates.begin(), registerMirror(outline, outline, clicked));
    candidates.push_back({clicked, mirrorResidual(outline, outline, clicked, 1e3)});
    const MirrorRegistration* best = nullptr;
    for (const MirrorRegistration& candidate : candidates) {
      const bool near = axisTurn(candidate.map, clicked) <= SymmetryTuning::kClickTurn &&
                        (candidate.map(middle) - middle).norm() / 2 <= SymmetryTuning::kClickShift;
      if (near && (!best || (mirrors(candidate) && !mirrors(*best)) ||
                   candidate.residual + 2 * Outline::kFlatness < best->residual))
        best = &candidate;
    }
    return Registered{measured(piece, piece, *best),
                      "piece " + inQuotes(panel.name) + " does not mirror across the given axis",
                      "move the axis, or choose two edges that mirror each other"};
  }

  Outcome<Registered> operator()(const EdgesRequest& request) {
    const int piece = garment_.find(request.piece);
    const Panel& panel = garment_.panels[piece];
    const int count = static_cast<int>(panel.edges.size());
    for (const int edge : {request.first, request.second})
      if (edge < 0 || edge >= count)
        return malformed("piece " + inQuotes(panel.name) + " has no edge " + decimal(edge) +
                             "; its edges are 0 to " + decimal(count - 1),
                         piece);
    if (request.first == request.second)
      return malformed("edge " + decimal(request.first) + " of piece " + inQuotes(panel.name) +
                           " is named twice; name two edges that mirror each other",
                       piece);
    const Curve &first = panel.edges[request.first], &second = panel.edges[request.second];
    const Outline outline(panel);
    const MirrorRegistration registered =
        registerMirror(outline, outline, registerEdges(first, second));
    // Two edges alone may not determine the mirror (straight edges of unequal length slide along
    // each other). In this case use the piece's own mirror that carries one edge to the other.
    std::vector<MirrorRegistration> candidates = findMirrors(outline, outline);
    candidates.insert(candidates.begin(), registered);
    const MirrorRegistration* best = nullptr;
    double least = SymmetryTuning::kEdgesMeet;
    for (const MirrorRegistration& candidate : candidates) {
      const double apart = edgeResidual(first, second, candidate.map);
      if (!mirrors(candidate) || apart > least - (best ? Outline::kFlatness : 0)) continue;
      best = &candidate;
      least = apart;
    }
    if (best) return Registered{measured(piece, piece, *best), "", ""};
    const std::string edges = "edges " + decimal(request.first) + " and " +
                              decimal(request.second) + " of piece " + inQuotes(panel.name);
    const RigidMotion across = registerEdges(first, second);
    const double residual = std::max(mirrorResidual(outline, outline, across, 1e3),
                                     edgeResidual(first, second, across));
    return Registered{{{{piece, piece}, across, residual}, false},
                      edges + " do not mirror onto each other with the whole piece",
                      "choose two other edges, or leave the piece free"};
  }

  Outcome<Registered> operator()(const PieceRequest& request) {
    const int piece = garment_.find(request.piece);
    return between(piece, piece, "piece " + inQuotes(request.piece) + " is not symmetric in itself",
                   "leave it free, or name its partner");
  }

  Outcome<Registered> operator()(const PairRequest& request) {
    return between(garment_.find(request.first), garment_.find(request.second),
                   "pieces " + inQuotes(request.first) + " and " + inQuotes(request.second) +
                       " are not mirror images",
                   "choose another pair");
  }

 private:
  static bool mirrors(const MirrorRegistration& candidate) {
    return candidate.residual <= kMirrorTolerance;
  }

  MeasuredSymmetry measured(int from, int to, const MirrorRegistration& candidate) const {
    return {bodySymmetry(garment_, from, to, candidate), mirrors(candidate)};
  }

  Registered between(int from, int to, const std::string& complaint, const std::string& remedy) {
    if (!maps_) {
      maps_.emplace(garment_);
      while (maps_->advance()) {
      }
    }
    std::vector<int> candidates;
    for (const int m : maps_->mapsFrom(from))
      if (maps_->maps()[m].to == to) candidates.push_back(m);
    const int chosen = likeliestMap(*maps_, candidates);
    const MirrorRegistration& candidate =
        chosen >= 0 ? maps_->maps()[chosen].registration
                    : bestMirror(maps_->outline(from), maps_->outline(to));
    return {measured(from, to, candidate), complaint, remedy};
  }

  const Garment& garment_;
  std::optional<SeamMaps> maps_;  // computed on demand, because it compares all pieces
};

struct PieceNames {
  std::vector<std::string> operator()(const PairRequest& r) const { return {r.first, r.second}; }
  template <class Single>
  std::vector<std::string> operator()(const Single& r) const {
    return {r.piece};
  }
};

std::vector<std::string> namesIn(const SymmetryRequest& request) {
  return std::visit(PieceNames{}, request);
}

std::optional<Error> unknownPiece(const Garment& garment, const SymmetryRequest& request) {
  for (const std::string& name : namesIn(request))
    if (garment.find(name) < 0)
      return Error{Failure::kSymmetryUnknownPiece,
                   "a symmetry names piece " + inQuotes(name) +
                       ", which the garment does not have; check its spelling"};
  return {};
}

}  // namespace

Outcome<std::vector<BodySymmetry>> registerSymmetries(
    const Garment& garment, const std::vector<SymmetryRequest>& requests) {
  std::vector<char> taken(garment.panels.size(), 0);
  for (const SymmetryRequest& request : requests) {
    if (const auto error = unknownPiece(garment, request)) return *error;
    for (const std::string& name : namesIn(request)) {
      const int piece = garment.find(name);
      if (taken[piece])
        return Error{Failure::kSymmetryConflict,
                     "piece " + inQuotes(name) + " is named twice in the symmetries; keep one",
                     piece};
      taken[piece] = 1;
    }
  }
  Registrar registrar(garment);
  std::vector<BodySymmetry> found;
  for (const SymmetryRequest& request : requests) {
    const Outcome<Registered> registered = std::visit(registrar, request);
    if (!registered.ok()) return registered.error();
    if (!registered.value().measured.mirrors) return doesNotMirror(registered.value());
    found.push_back(registered.value().measured.symmetry);
  }
  return found;
}

Outcome<std::vector<MeasuredSymmetry>> measureSymmetries(
    const Garment& garment, const std::vector<SymmetryRequest>& requests) {
  Registrar registrar(garment);
  std::vector<MeasuredSymmetry> measured;
  for (const SymmetryRequest& request : requests) {
    if (const auto error = unknownPiece(garment, request)) return *error;
    const Outcome<Registered> registered = std::visit(registrar, request);
    if (!registered.ok()) return registered.error();
    measured.push_back(registered.value().measured);
  }
  return measured;
}

std::string namesOf(const Garment& garment, const BodySymmetry& symmetry) {
  const std::string first = inQuotes(garment.panels[symmetry.pieces[0]].name);
  return symmetry.single() ? first
                           : first + " and " + inQuotes(garment.panels[symmetry.pieces[1]].name);
}

std::vector<int> piecesOf(const BodySymmetry& symmetry) {
  if (symmetry.single()) return {symmetry.pieces[0]};
  return {symmetry.pieces[0], symmetry.pieces[1]};
}

}  // namespace seamwise
