#include "photo/base/fourier.h"

#include <algorithm>

#include "base/lanes.h"
#include "geometry/vec2.h"

namespace seamwise {
namespace {

/// Four complex numbers, one per line.
struct ComplexLanes {
  Lanes<float>::Vector re, im;
};

ComplexLanes operator+(const ComplexLanes& a, const ComplexLanes& b) {
  return {a.re + b.re, a.im + b.im};
}
ComplexLanes operator-(const ComplexLanes& a, const ComplexLanes& b) {
  return {a.re - b.re, a.im - b.im};
}
ComplexLanes operator*(const ComplexLanes& a, const ComplexFloat& b) {
  return {a.re * b.real() - a.im * b.imag(), a.re * b.imag() + a.im * b.real()};
}

/// Transforms of one length by successive radices, each of which sorts its results [Stockham 1966].
class FourierPlan {
 public:
  FourierPlan(int length, bool inverse) : length_(length), turns_(length), other_(length) {
    for (int k = 0; k < length; ++k) {
      const Vec2 turn = unit((inverse ? 2 : -2) * kPi * k / length);
      turns_[k] = {static_cast<float>(turn.x()), static_cast<float>(turn.y())};
    }
  }

  void transform(std::vector<ComplexLanes>& x) {
    int rest = length_;
    while (rest > 1) {
      const int radix = radixOf(rest);
      rest /= radix;
      const int apart = length_ / (rest * radix);
      for (int p = 0; p < rest; ++p) {
        const ComplexLanes* const from = &x[p * apart];
        ComplexLanes* const to = &other_[p * apart * radix];
        for (int q = 0; q < apart; ++q) by(radix, from + q, rest * apart, p * apart, to + q, apart);
      }
      x.swap(other_);
    }
  }

 private:
  static int radixOf(int n) {
    int radix = 2;
    while (n % radix != 0) ++radix;
    return radix;
  }

  /// Computes one butterfly. Outputs u and radix - u share their sums and differences.
  /// @param turn   rotation of output 1, in parts 1 / length of a whole turn
  void by(int radix, const ComplexLanes* from, int from_step, int turn, ComplexLanes* to,
          int to_step) {
    const int part = length_ / radix, half = (radix - 1) / 2;
    ComplexLanes all = from[0];
    for (int t = 1; t < radix; ++t) all = all + from[t * from_step];
    for (int u = 1; u <= half; ++u) {
      ComplexLanes even = from[0], odd = {};
      for (int t = 1; t <= half; ++t) {
        const ComplexLanes a = from[t * from_step], b = from[(radix - t) * from_step];
        const ComplexFloat share = turns_[t * u % radix * part];
        even = even + (a + b) * ComplexFloat(share.real(), 0);
        odd = odd + (a - b) * ComplexFloat(0, share.imag());
      }
      to[u * to_step] = (even + odd) * turns_[u * turn];
      to[(radix - u) * to_step] = (even - odd) * turns_[(radix - u) * turn];
    }
    if (radix == 2) to[to_step] = (from[0] - from[from_step]) * turns_[turn];
    to[0] = all;
  }

  int length_;
  std::vector<ComplexFloat> turns_;
  std::vector<ComplexLanes> other_;
};

}  // namespace

void transformLines(std::vector<ComplexFloat>& plane, const FourierLines& lines, bool inverse) {
  constexpr int kTogether = Lanes<float>::kCount;
  FourierPlan plan(lines.length, inverse);
  std::vector<ComplexLanes> x(lines.length);
  for (int first = 0; first < lines.count; first += kTogether) {
    ComplexFloat* const from = plane.data() + static_cast<std::size_t>(first) * lines.apart;
    const int count = std::min(kTogether, lines.count - first);
    for (int k = 0; k < lines.length; ++k) {
      for (int j = 0; j < count; ++j) {
        const ComplexFloat& number = from[j * lines.apart + k * lines.step];
        x[k].re[j] = number.real();
        x[k].im[j] = number.imag();
      }
    }
    plan.transform(x);
    for (int k = 0; k < lines.length; ++k) {
      for (int j = 0; j < count; ++j)
        from[j * lines.apart + k * lines.step] = {x[k].re[j], x[k].im[j]};
    }
  }
}

}  // namespace seamwise
