#pragma once
#include <complex>
#include <vector>

namespace seamwise {

using ComplexFloat = std::complex<float>;

/// Complex product without the library's checks for infinities.
inline ComplexFloat productOf(const ComplexFloat& a, const ComplexFloat& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// Lines of numbers in a plane: number k of line j is at j * apart + k * step.
struct FourierLines {
  int count = 0, length = 0;
  int apart = 0, step = 1;
};

/// Computes the discrete Fourier transforms of all lines, in place and unscaled: the sum of x(k)
/// exp(-+2 pi I k l / length), four lines at once. It is fast if the length has no prime factor
/// above 5.
void transformLines(std::vector<ComplexFloat>& plane, const FourierLines& lines,
                    bool inverse = false);

}  // namespace seamwise
