#pragma once
#include <vector>

#include "photo/symmetry/cell_spectrum.h"
#include "wallpaper/group.h"

namespace seamwise {

/// Embedding of a wallpaper group in a given lattice: the basis that its convention requires, and
/// its elements, one per coset, in coordinates of the given basis about the group's origin.
struct GroupEmbedding {
  IntegerMatrix basis{1, 0, 0, 1};  ///< w1, w2 of the group as columns, determinant +1
  std::vector<LatticeElement> elements;
};

/// Returns all embeddings that differ in their elements; none if the lattice does not allow the
/// group.
/// @param gram        Gram matrix of the lattice's basis, in any unit of area
/// @param tolerance   maximum difference of lengths that must be equal, as a share, and of angles
///                    [rad]
std::vector<GroupEmbedding> embeddingsOf(const GroupData& group, const Mat2& gram,
                                         double tolerance);

/// Returns the change to a basis of shortest vectors (Lagrange), an integer matrix with determinant
/// +1.
Mat2 reducingMatrix(const Mat2& gram);

}  // namespace seamwise
