#pragma once
#include <array>

namespace seamwise {

/// Of normal equations with as many unknowns as a lattice in perspective has, or fewer.
constexpr int kMostUnknowns = 7;
using NormalMatrix = std::array<std::array<double, kMostUnknowns>, kMostUnknowns>;

/// The inverse of the first n rows and columns of A, symmetric and positive definite, by
/// Cholesky's method; false where it is not so.
bool invertNormal(const NormalMatrix& a, int n, NormalMatrix& inverse);

}  // namespace seamwise
