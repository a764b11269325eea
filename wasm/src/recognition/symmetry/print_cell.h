#pragma once
#include "recognition/base/cell_picture.h"
#include "recognition/base/picture.h"
#include "recognition/symmetry/group_reading.h"

namespace seamwise {

/// The cell in the basis of a group's convention, the group's origin at its first sample. It has an
/// even number of samples along a side, so that glides by half a repeat keep to samples.
CellPicture rebased(const CellPicture& cell, const GroupVerdict& verdict);

/// The rebased cell, made exactly symmetric: each sample the mean of its images under the group,
/// which are samples, too.
/// @param stripes   makes it the same along w2 as well
CellPicture symmetrised(const CellPicture& cell, const GroupVerdict& verdict, bool stripes = false);

/// The print on a parallelogram as pixels, the first row at its upper end: a corner, and its sides
/// as columns, in lattice coordinates of the cell.
Picture printPicture(const CellPicture& cell, const Mat2& sides, const Vec2& corner, int width,
                     int height);

}  // namespace seamwise
