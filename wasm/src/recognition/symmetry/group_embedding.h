#pragma once
#include <vector>

#include "recognition/symmetry/cell_spectrum.h"
#include "wallpaper/group.h"

namespace seamwise {

/// A way in which a wallpaper group fits a given lattice: the basis that its convention asks for,
/// and its elements, one per coset, in coordinates of the given basis about the group's origin.
struct GroupEmbedding {
  IntegerMatrix basis{1, 0, 0, 1};  ///< w1, w2 of the group as columns, determinant +1
  std::vector<LatticeElement> elements;
};

/// All ways that differ in their elements; none if the lattice lacks what the group needs.
/// @param gram        of the lattice's basis, in any unit of area
/// @param tolerance   greatest difference of lengths that must be equal, as a share, and of angles
///                    [rad]
std::vector<GroupEmbedding> embeddingsOf(const GroupData& group, const Mat2& gram,
                                         double tolerance);

/// The change to a basis of shortest vectors (Lagrange), whole numbers of determinant +1.
Mat2 reducingMatrix(const Mat2& gram);

}  // namespace seamwise
