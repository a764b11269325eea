#pragma once
#include <complex>
#include <vector>

namespace seamwise {

using ComplexFloat = std::complex<float>;

/// Discrete Fourier transform of n x n numbers, row by row, in place and unscaled: the sum of
/// x(j, i) exp(-+2 pi I (j l + i k) / n). Fast where n has no prime factor above 5.
void squareFourier(std::vector<ComplexFloat>& values, int n, bool inverse);

}  // namespace seamwise
