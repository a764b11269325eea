#include "photo/symmetry/symmetry_tests.h"

#include <Eigen/LU>
#include <algorithm>

#include "geometry/principal_axes.h"
#include "photo/base/repeating_place.h"
#include "tuning/group_reading.h"

namespace seamwise {
namespace {

using SymmetryTuning = GroupReadingTuning;

Vec2 fractionOf(const Vec2& v) { return v - v.array().floor().matrix(); }

/// Sums over a place: d is the difference of two pictures, g = (g1, g2) the gradient.
struct PlaceSums {
  double dd = 0, d1 = 0, d2 = 0, g11 = 0, g12 = 0, g22 = 0, noise = 0;
  int samples = 0;
  void add(const PlaceSums& o) {
    dd += o.dd, d1 += o.d1, d2 += o.d2, g11 += o.g11, g12 += o.g12, g22 += o.g22;
    noise += o.noise, samples += o.samples;
  }
  Mat2 gradients() const { return (Mat2() << g11, g12, g12, g22).finished(); }
  /// Returns the sum of squares of d after a displacement of the picture by x samples.
  double displaced(const Vec2& x) const {
    return dd + 2 * (d1 * x.x() + d2 * x.y()) + x.dot(gradients() * x);
  }
};

/// Returns the displacement of a neighbourhood that explains most of its difference, limited to
/// displacements by creases. [samples]
Vec2 displacementOf(const PlaceSums& sums, const Mat2& gram, int n, double variance) {
  const Mat2 metric = gram / (n * n);  // metric of displacements in samples
  constexpr double kLimit = SymmetryTuning::kDisplacement * SymmetryTuning::kDisplacement;
  const Mat2 system = sums.gradients() + variance / kLimit * metric;
  Vec2 x = -system.inverse() * Vec2(sums.d1, sums.d2);
  const double square = x.dot(metric * x) / (4 * kLimit);
  if (square > 1) x /= std::sqrt(square);
  return x;
}

/// Returns the minimum of a quadratic through 3 x 3 values, in steps from the middle. Directions
/// with hardly any curvature count as flat.
Vec2 leastOf(const double (&v)[3][3]) {
  const Vec2 slope((v[1][2] - v[1][0]) / 2, (v[2][1] - v[0][1]) / 2);
  Mat2 bend;
  bend(0, 0) = v[1][2] - 2 * v[1][1] + v[1][0];
  bend(1, 1) = v[2][1] - 2 * v[1][1] + v[0][1];
  bend(0, 1) = bend(1, 0) = (v[2][2] - v[2][0] - v[0][2] + v[0][0]) / 4;
  const PrincipalAxes axes(bend);
  Vec2 step = Vec2::Zero();
  const auto go = [&](double curvature, const Vec2& axis) {
    if (curvature <= 1e-3 * std::max(1e-9, axes.greater)) return;
    step -= std::clamp(slope.dot(axis) / curvature, -1.0, 1.0) * axis;
  };
  go(axes.lesser, perp(axes.axis));
  go(axes.greater, axes.axis);
  return step;
}

}  // namespace

Vec2 shiftAbout(const LatticeElement& e, const Vec2& o) {
  return {(1 - e.m[0]) * o.x() - e.m[1] * o.y() + e.a[0],
          -e.m[2] * o.x() + (1 - e.m[3]) * o.y() + e.a[1]};
}

SymmetryTests::SymmetryTests(const CellSpectrum& cell) : cell_(cell) {
  const int n = cell.n();
  for (int channel = 0; channel < CellSpectrum::kChannels; ++channel) {
    const std::vector<float>& plane = cell.planes()[channel];
    along1_[channel].resize(plane.size());
    along2_[channel].resize(plane.size());
    for (int j = 0; j < n; ++j) {
      const int below = (j + n - 1) % n * n, above = (j + 1) % n * n;
      for (int i = 0; i < n; ++i) {
        const int left = (i + n - 1) % n, right = (i + 1) % n;
        along1_[channel][j * n + i] = (plane[j * n + right] - plane[j * n + left]) / 2;
        along2_[channel][j * n + i] = (plane[above + i] - plane[below + i]) / 2;
      }
    }
  }
}

double SymmetryTests::patternEnergy() const {
  return std::max(1e-12, cell_.energy() - cell_.noiseEnergy());
}

const std::vector<float>& SymmetryTests::correlation(const IntegerMatrix& m) {
  for (const auto& [known, values] : correlations_) {
    if (known == m) return values;
  }
  return correlations_.emplace_front(m, cell_.correlation(m)).second;
}

Vec2 SymmetryTests::bestOrigin(const GroupEmbedding& embedding) {
  const int fine = 2 * cell_.n();
  std::vector<float> agreement(static_cast<std::size_t>(fine) * fine, 0.0f);
  int others = 0;
  for (const LatticeElement& e : embedding.elements) {
    if (e.m == IntegerMatrix{1, 0, 0, 1}) continue;
    ++others;
    const std::vector<float>& values = correlation(e.m);
    const int step1 = wrappedIndex(1 - e.m[0], fine), step2 = wrappedIndex(-e.m[2], fine);
    const int half1 = static_cast<int>(std::lround(e.a[0] * fine));
    const int half2 = static_cast<int>(std::lround(e.a[1] * fine));
    for (int q = 0; q < fine; ++q) {
      int s1 = wrappedIndex(half1 - e.m[1] * q, fine);
      int s2 = wrappedIndex(half2 + (1 - e.m[3]) * q, fine);
      float* const row = agreement.data() + static_cast<std::size_t>(q) * fine;
      for (int p = 0; p < fine; ++p) {
        row[p] += values[s2 * fine + s1];
        if ((s1 += step1) >= fine) s1 -= fine;
        if ((s2 += step2) >= fine) s2 -= fine;
      }
    }
  }
  if (others == 0) return Vec2::Zero();
  const double whole = others * std::max(1e-12, cell_.energy());
  // Rounding alone must not choose between equal origins.
  const float margin = static_cast<float>(1e-5 * whole);
  std::size_t best = 0;
  for (std::size_t k = 1; k < agreement.size(); ++k) {
    if (agreement[k] > agreement[best] + margin) best = k;
  }
  const int p = static_cast<int>(best % fine), q = static_cast<int>(best / fine);
  double around[3][3];
  for (int dq = -1; dq <= 1; ++dq) {
    for (int dp = -1; dp <= 1; ++dp) {
      const int at = wrappedIndex(q + dq, fine) * fine + wrappedIndex(p + dp, fine);
      around[dq + 1][dp + 1] = -agreement[at] / whole;
    }
  }
  return fractionOf((Vec2(p, q) + leastOf(around)) / fine);
}

double SymmetryTests::missedBy(const GroupEmbedding& embedding, const Vec2& origin) {
  const int fine = 2 * cell_.n();
  double sum = 0;
  int others = 0;
  for (const LatticeElement& e : embedding.elements) {
    if (e.m == IntegerMatrix{1, 0, 0, 1}) continue;
    const Vec2 a = shiftAbout(e, origin) * fine;
    const int s1 = wrappedIndex(static_cast<int>(std::lround(a.x())), fine);
    const int s2 = wrappedIndex(static_cast<int>(std::lround(a.y())), fine);
    sum += 1 - correlation(e.m)[s2 * fine + s1] / std::max(1e-12, cell_.energy());
    ++others;
  }
  return others == 0 ? 0 : sum / others;
}

SymmetryResidual SymmetryTests::residual(const IntegerMatrix& m, const Vec2& a) const {
  const int n = cell_.n(), places = std::min(SymmetryTuning::kPlaces, n / 2);
  const CellSpectrum::Planes image = cell_.image(m, a);
  std::vector<PlaceSums> sums(static_cast<std::size_t>(places) * places);
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      PlaceSums& place = sums[j * places / n * places + i * places / n];
      const std::size_t p = static_cast<std::size_t>(j) * n + i;
      place.samples += 1;
      place.noise += cell_.noise()[p];
      for (int channel = 0; channel < CellSpectrum::kChannels; ++channel) {
        const float d = cell_.planes()[channel][p] - image[channel][p];
        const float g1 = along1_[channel][p], g2 = along2_[channel][p];
        place.dd += d * d;
        place.d1 += d * g1;
        place.d2 += d * g2;
        place.g11 += g1 * g1;
        place.g12 += g1 * g2;
        place.g22 += g2 * g2;
      }
    }
  }
  const double energy = patternEnergy();
  constexpr double kLeft =
      SymmetryTuning::kLeftDisplacement * SymmetryTuning::kLeftDisplacement / 2;
  const double amplitude = SymmetryTuning::kLeftAmplitude * SymmetryTuning::kLeftAmplitude * energy;
  const Mat2 inverse = cell_.gram().inverse() * (n * n);
  SymmetryResidual result;
  double total = 0;
  for (int y = 0; y < places; ++y) {
    for (int x = 0; x < places; ++x) {
      PlaceSums around;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          around.add(sums[(y + dy + places) % places * places + (x + dx + places) % places]);
        }
      }
      const double variance = 2 * around.noise / around.samples + amplitude;
      const Vec2 moved = displacementOf(around, cell_.gram(), n, variance);
      const PlaceSums& place = sums[y * places + x];
      const double steepness =
          place.g11 * inverse(0, 0) + 2 * place.g12 * inverse(0, 1) + place.g22 * inverse(1, 1);
      const double allowed = place.noise + kLeft * steepness + amplitude * place.samples;
      const double left = place.displaced(moved) / 2 - allowed;
      total += left;
      result.raw += place.dd / 2;
      result.worst = std::max(result.worst, left / (place.samples * energy));
    }
  }
  const double scale = static_cast<double>(n) * n * energy;
  result.rho = std::max(0.0, total / scale);
  result.raw /= scale;
  return result;
}

SymmetryResidual SymmetryTests::residual(const GroupEmbedding& embedding,
                                         const Vec2& origin) const {
  SymmetryResidual furthest;
  for (const LatticeElement& e : embedding.elements) {
    if (e.m == IntegerMatrix{1, 0, 0, 1}) continue;
    const SymmetryResidual one = residual(e.m, shiftAbout(e, origin));
    furthest.rho = std::max(furthest.rho, one.rho);
    furthest.worst = std::max(furthest.worst, one.worst);
    furthest.raw = std::max(furthest.raw, one.raw);
  }
  return furthest;
}

}  // namespace seamwise
