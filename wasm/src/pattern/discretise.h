#pragma once
#include <cstdint>

#include "base/outcome.h"
#include "pattern/garment.h"
#include "pattern/pattern.h"

namespace seamwise {

/// Limit on the vertices that symmetries add. kTrial: a few per corner. kFull: as many as needed if
/// symmetries and seams disagree.
enum class Effort : std::uint8_t { kFull, kTrial };

/// Samples every outline so that both sides of a seam have the same vertices in sewing order and
/// mirror images have mirrored vertices. The pattern has no interior vertices or triangles yet.
///
/// Every edge is cut at breakpoints (fractions of its arc length). These are its ends, the
/// crossings of a symmetry axis, and the counterparts of breakpoints of its seam partner (same
/// fraction in sewing order) and of its mirror images (the image point), until nothing changes.
/// Intervals that are tied by a seam or a mirror share one count, that of the longest of them at
/// `edge_length`. Vertices inside an interval are evenly spaced by arc length. Unsewn edges are
/// sampled in the same way.
///
/// @param sampled   symmetries that the sampling follows (all known ones, imposed or not)
/// @param imposed   symmetries for Pattern::mirrors, with `image` filled for the outline and hole
///                  vertices; must be among `sampled`
/// @param edge_length   greatest edge on a seam, cm
/// Errors: kMesh if a mirror image has no one-to-one correspondence, naming the piece.
Outcome<Pattern> discretise(const Garment& garment, const std::vector<BodySymmetry>& sampled,
                            const std::vector<BodySymmetry>& imposed, double edge_length,
                            Effort effort = Effort::kFull);

}  // namespace seamwise
