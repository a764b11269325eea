#pragma once
#include <cmath>
#include <cstring>

namespace seamwise {

/// A vector that one instruction processes at once: 4 floats or 2 doubles. GCC and Clang share this
/// vector extension, so the same source compiles to SSE, NEON and WebAssembly SIMD.
template <class Real>
struct Lanes;
template <>
struct Lanes<float> {
  using Vector __attribute__((vector_size(16))) = float;
  static constexpr int kCount = 4;
};
template <>
struct Lanes<double> {
  using Vector __attribute__((vector_size(16))) = double;
  static constexpr int kCount = 2;
};

template <class Real>
inline typename Lanes<Real>::Vector loaded(const Real* from) {
  typename Lanes<Real>::Vector v;
  std::memcpy(&v, from, sizeof v);
  return v;
}

template <class Vector>
inline Vector abs(const Vector& x) {
  return x > -x ? x : -x;
}

template <class Vector>
inline Vector least(const Vector& x, const Vector& y) {
  return x < y ? x : y;
}

template <class Vector>
inline Vector greatest(const Vector& x, const Vector& y) {
  return x > y ? x : y;
}

/// The square roots of numbers that are not negative.
inline Lanes<float>::Vector squareRoots(const Lanes<float>::Vector& x) {
  const Lanes<float>::Vector roots = {std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]),
                                      std::sqrt(x[3])};
  return roots;
}
inline Lanes<double>::Vector squareRoots(const Lanes<double>::Vector& x) {
  const Lanes<double>::Vector roots = {std::sqrt(x[0]), std::sqrt(x[1])};
  return roots;
}

/// The sum over all lanes, in double precision.
template <class Vector>
inline double sumOf(const Vector& x) {
  double sum = 0;
  for (std::size_t i = 0; i < sizeof(x) / sizeof(x[0]); ++i) sum += static_cast<double>(x[i]);
  return sum;
}

}  // namespace seamwise
