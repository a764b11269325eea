#pragma once
#include <array>

namespace seamwise {

/// Maximum number of unknowns, that of a lattice in perspective.
constexpr int kMostUnknowns = 7;
using NormalMatrix = std::array<std::array<double, kMostUnknowns>, kMostUnknowns>;

/// Computes the inverse of the first n rows and columns of a symmetric matrix A by Cholesky's
/// method. Returns false unless they are positive definite.
bool invertNormal(const NormalMatrix& a, int n, NormalMatrix& inverse);

}  // namespace seamwise
