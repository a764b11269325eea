#include "mesh/mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/in_quotes.h"
#include "mesh/mirrored.h"
#include "mesh/region.h"
#include "pattern/seam_measure.h"

namespace seamwise {
namespace {

Error pieceError(const Pattern& pattern, int piece, const std::string& why) {
  return {Failure::kMesh, "piece " + inQuotes(pattern.pieces[piece].name) + " " + why, piece};
}

}  // namespace

Meshing::Meshing(Pattern pattern, double coarsest, const std::vector<Panel>* panels)
    : pattern_(std::move(pattern)),
      coarsest_(coarsest),
      panels_(panels),
      done_(pattern_.pieces.size(), false) {
  if (!(coarsest > 0) || !std::isfinite(coarsest))
    error_ = {Failure::kOptions, "the mesh size must be a positive number of centimetres"};
}

bool Meshing::advance() {
  if (error_) return false;
  if (mirrors_ < pattern_.mirrors.size()) {
    error_ = fillMirrored(pattern_.mirrors[mirrors_++]);
    return !error_;
  }
  while (pieces_ < done_.size() && done_[pieces_]) ++pieces_;
  if (pieces_ == done_.size()) return false;
  error_ = fill(static_cast<int>(pieces_++));
  return !error_;
}

double Meshing::fraction() const {
  const auto done = static_cast<double>(std::count(done_.begin(), done_.end(), true));
  return done_.empty() ? 1 : done / static_cast<double>(done_.size());
}

std::optional<Error> Meshing::fillMirrored(Mirror& mirror) {
  for (const int p : mirror.pieces)
    if (done_[p]) return pieceError(pattern_, p, "takes part in two symmetries; leave one out");
  const Outcome<bool> moved =
      meshMirrored(pattern_, mirror, coarsest_, creasesOf(mirror.pieces[0]));
  if (!moved.ok()) return moved.error();
  moved_ = moved_ || moved.value();
  for (const int p : mirror.pieces) done_[p] = true;
  return {};
}

std::vector<Crease> Meshing::creasesOf(int piece) const {
  std::vector<Crease> creases;
  if (!panels_) return creases;
  for (const Fold& fold : (*panels_)[piece].folds) {
    if (!fold.takesUp()) continue;
    creases.push_back(fold.line);
    creases.push_back(fold.to);
  }
  return creases;
}

std::optional<Error> Meshing::fill(int p) {
  Piece& piece = pattern_.pieces[p];
  std::vector<std::vector<int>> loops{piece.outline};
  loops.insert(loops.end(), piece.holes.begin(), piece.holes.end());
  auto mesh = meshRegion(piece.rest, loops, coarsest_, creasesOf(p));
  if (!mesh)
    return pieceError(pattern_, p,
                      "cannot be filled with triangles: its outline crosses or touches itself or "
                      "a cut-out; redraw it there");
  piece.rest.insert(piece.rest.end(), mesh->interior.begin(), mesh->interior.end());
  piece.triangles = std::move(mesh->triangles);
  done_[p] = true;
  return {};
}

Outcome<Pattern> Meshing::take() {
  if (error_) return *error_;
  if (moved_) setLengthRatios(pattern_);
  return std::move(pattern_);
}

Outcome<Pattern> meshed(Pattern pattern, double coarsest) {
  Meshing meshing(std::move(pattern), coarsest);
  while (meshing.advance()) {
  }
  return meshing.take();
}

}  // namespace seamwise
