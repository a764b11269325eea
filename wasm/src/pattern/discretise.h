#pragma once
#include <cstdint>

#include "base/outcome.h"
#include "pattern/garment.h"
#include "pattern/pattern.h"

namespace seamwise {

/// How many vertices symmetries may add: a few per corner, or as many as it takes where they
/// and the seams disagree.
enum class Effort : std::uint8_t { kFull, kTrial };

/// Samples every outline so that both sides of a seam have the same vertices in sewing order and
/// mirror images have mirrored vertices. No interior vertices or triangles yet.
///
/// Every edge is cut at breakpoints (fractions of its arc length): its ends, where a symmetry axis
/// crosses it, and what the breakpoints of its seam partner (same fraction in sewing order) and of
/// its mirror images (the image point) demand, until nothing changes. Intervals that are tied by a
/// seam or a mirror share one count, that of the longest of them at `edge_length`; inside an
/// interval the vertices are evenly spaced by arc length. Unsewn edges likewise.
///
/// @param sampled   symmetries that the sampling follows (all known ones, imposed or not)
/// @param imposed   symmetries that end up in Pattern::mirrors, with `image` filled for the outline
///                  and hole vertices; must be among `sampled`
/// @param edge_length   greatest edge on a seam, cm
/// Errors: kMesh when a mirror image cannot be put into one-to-one correspondence, naming the
/// piece.
Outcome<Pattern> discretise(const Garment& garment, const std::vector<BodySymmetry>& sampled,
                            const std::vector<BodySymmetry>& imposed, double edge_length,
                            Effort effort = Effort::kFull);

}  // namespace seamwise
