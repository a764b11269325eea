#include "deform/mesh.h"

#include <cmath>

#include "deform/mirrored.h"
#include "deform/region.h"
#include "geometry/in_quotes.h"
#include "pattern/seam_measure.h"

namespace seamwise {
namespace {

Error pieceError(const Pattern& pattern, int piece, const std::string& why) {
  return {Failure::kMesh, "piece " + inQuotes(pattern.pieces[piece].name) + " " + why, piece};
}

}  // namespace

Outcome<Pattern> meshed(Pattern pattern, double coarsest) {
  if (!(coarsest > 0) || !std::isfinite(coarsest))
    return Error{Failure::kOptions, "the mesh size must be a positive number of centimetres"};
  std::vector<bool> done(pattern.pieces.size(), false);
  bool moved = false;
  for (Mirror& mirror : pattern.mirrors) {
    for (const int p : mirror.pieces)
      if (done[p]) return pieceError(pattern, p, "takes part in two symmetries; leave one out");
    const auto outcome = meshMirrored(pattern, mirror, coarsest);
    if (!outcome.ok()) return outcome.error();
    moved = moved || outcome.value();
    for (const int p : mirror.pieces) done[p] = true;
  }
  for (std::size_t p = 0; p < pattern.pieces.size(); ++p) {
    if (done[p]) continue;
    Piece& piece = pattern.pieces[p];
    std::vector<std::vector<int>> loops{piece.outline};
    loops.insert(loops.end(), piece.holes.begin(), piece.holes.end());
    auto mesh = meshRegion(piece.rest, loops, coarsest);
    if (!mesh)
      return pieceError(pattern, static_cast<int>(p),
                        "cannot be filled with triangles: its outline crosses or touches itself or "
                        "a cut-out; redraw it there");
    piece.rest.insert(piece.rest.end(), mesh->interior.begin(), mesh->interior.end());
    piece.triangles = std::move(mesh->triangles);
  }
  if (moved) measureSeams(pattern);
  return pattern;
}

}  // namespace seamwise
