#pragma once
#include <array>
#include <cmath>

namespace seamwise {

/// A value that depends on a point in space, with its first and second derivatives there.
struct Jet {
  double value = 0;
  std::array<double, 3> gradient{};
  std::array<double, 6> hessian{};  ///< xx, xy, xz, yy, yz, zz

  static constexpr int kRow[6] = {0, 0, 0, 1, 1, 2}, kColumn[6] = {0, 1, 2, 1, 2, 2};

  static Jet variable(double value, int axis) {
    Jet jet{value, {}, {}};
    jet.gradient[axis] = 1;
    return jet;
  }

  /// f of this, given f, f' and f'' at the value.
  Jet chain(double f, double slope, double bend) const {
    Jet out{f, {}, {}};
    for (int i = 0; i < 3; ++i) out.gradient[i] = slope * gradient[i];
    for (int k = 0; k < 6; ++k)
      out.hessian[k] = slope * hessian[k] + bend * (gradient[kRow[k]] * gradient[kColumn[k]]);
    return out;
  }
};

inline Jet operator+(const Jet& a, const Jet& b) {
  Jet out{a.value + b.value, {}, {}};
  for (int i = 0; i < 3; ++i) out.gradient[i] = a.gradient[i] + b.gradient[i];
  for (int k = 0; k < 6; ++k) out.hessian[k] = a.hessian[k] + b.hessian[k];
  return out;
}

inline Jet operator-(const Jet& a, const Jet& b) { return a + b.chain(-b.value, -1, 0); }

inline Jet operator*(const Jet& a, const Jet& b) {
  Jet out{a.value * b.value, {}, {}};
  for (int i = 0; i < 3; ++i) out.gradient[i] = a.value * b.gradient[i] + b.value * a.gradient[i];
  for (int k = 0; k < 6; ++k) {
    const int i = Jet::kRow[k], j = Jet::kColumn[k];
    out.hessian[k] = a.value * b.hessian[k] + b.value * a.hessian[k] +
                     (a.gradient[i] * b.gradient[j] + a.gradient[j] * b.gradient[i]);
  }
  return out;
}

inline Jet inverse(const Jet& a) {
  const double f = 1 / a.value;
  return a.chain(f, -f * f, 2 * f * f * f);
}

inline Jet root(const Jet& a) {
  const double f = std::sqrt(a.value);
  return a.chain(f, 0.5 / f, -0.25 / (f * a.value));
}

}  // namespace seamwise
