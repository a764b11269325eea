#include "photo/symmetry/cell_spectrum.h"

#include <Eigen/LU>

#include "tuning/group_reading.h"

namespace seamwise {
namespace {

/// Transforms the rows, then the columns.
void squareFourier(std::vector<ComplexFloat>& square, int n, bool inverse) {
  transformLines(square, {n, n, n, 1}, inverse);
  transformLines(square, {n, n, 1, n}, inverse);
}

/// Returns the index of a frequency in a transform of n numbers.
int frequencyIndex(int k, int n) { return k < 0 ? k + n : k; }

/// Returns exp(-2 pi I k a) for all k of a band.
std::vector<ComplexFloat> phasesOf(double a, int reach) {
  std::vector<ComplexFloat> phases(2 * reach + 1);
  for (int k = -reach; k <= reach; ++k) {
    const double turn = -2 * kPi * k * a;
    phases[k + reach] = {static_cast<float>(std::cos(turn)), static_cast<float>(std::sin(turn))};
  }
  return phases;
}

}  // namespace

CellSpectrum::CellSpectrum(const CellPicture& cell, const Mat2& gram)
    : n_(cell.n), reach_((cell.n - 1) / 2), gram_(gram / std::sqrt(gram.determinant())) {
  const std::size_t count = static_cast<std::size_t>(n_) * n_;
  const Mat2 inverse = gram_.inverse();
  // Greatest ellipse of equal wavelengths inside the band; rotations stay within it.
  const double most =
      reach_ * reach_ / std::max(gram_(0, 0), gram_(1, 1));  // k^T G^-1 k <= most => |k_i| <= reach
  std::vector<float> gain(count, 0.0f);
  double power = 0;
  for (int k2 = -reach_; k2 <= reach_; ++k2) {
    for (int k1 = -reach_; k1 <= reach_; ++k1) {
      const double square =
          k1 * k1 * inverse(0, 0) + 2.0 * k1 * k2 * inverse(0, 1) + k2 * k2 * inverse(1, 1);
      if (square > most * (1 + 1e-9)) continue;
      const double softening = kPi * GroupReadingTuning::kSoftening;
      const float g = std::exp(static_cast<float>(-2 * softening * softening * square));
      gain[frequencyIndex(k2, n_) * n_ + frequencyIndex(k1, n_)] = g;
      power += static_cast<double>(g) * g;
    }
  }
  gain[0] = 0;  // removes the mean

  const auto& [red, green, blue] = cell.planes;
  const float scale = 1.0f / static_cast<float>(count);
  for (int channel = 0; channel < kChannels; ++channel) {
    std::vector<ComplexFloat> values(count);
    for (std::size_t p = 0; p < count; ++p) {
      const float r = red[p], g = green[p], b = blue[p];
      values[p] = channel == 0   ? (r + g + b) / 3
                  : channel == 1 ? 0.7f * (r - b)
                                 : 0.7f * (g - (r + b) / 2);
    }
    squareFourier(values, n_, false);
    for (std::size_t p = 0; p < count; ++p) {
      values[p] *= gain[p] * scale;
      energy_ += std::norm(values[p]);
    }
    series_[channel] = values;
    squareFourier(values, n_, true);
    planes_[channel].resize(count);
    for (std::size_t p = 0; p < count; ++p) planes_[channel][p] = values[p].real();
  }
  // Gain on the variance of noise that is equal at all frequencies.
  const float left = static_cast<float>(power) * scale;
  noise_.resize(count);
  for (std::size_t p = 0; p < count; ++p) {
    noise_[p] = cell.noise[p] * left;
    noise_energy_ += noise_[p] * scale;
  }
}

ComplexFloat CellSpectrum::at(int channel, int k1, int k2) const {
  if (!inBand(k1, k2)) return 0;
  return series_[channel][frequencyIndex(k2, n_) * n_ + frequencyIndex(k1, n_)];
}

std::vector<float> CellSpectrum::correlation(const IntegerMatrix& m) const {
  const int fine = 2 * n_;
  std::vector<ComplexFloat> product(static_cast<std::size_t>(fine) * fine);
  for (int k2 = -reach_; k2 <= reach_; ++k2) {
    for (int k1 = -reach_; k1 <= reach_; ++k1) {
      const int to1 = m[0] * k1 + m[2] * k2, to2 = m[1] * k1 + m[3] * k2;
      ComplexFloat sum = 0;
      for (int channel = 0; channel < kChannels; ++channel) {
        sum += productOf(std::conj(at(channel, k1, k2)), at(channel, to1, to2));
      }
      product[frequencyIndex(k2, fine) * fine + frequencyIndex(k1, fine)] = sum;
    }
  }
  squareFourier(product, fine, false);
  std::vector<float> values(product.size());
  for (std::size_t p = 0; p < values.size(); ++p) values[p] = product[p].real();
  return values;
}

CellSpectrum::Planes CellSpectrum::image(const IntegerMatrix& m, const Vec2& a) const {
  const std::size_t count = static_cast<std::size_t>(n_) * n_;
  const auto phases1 = phasesOf(a.x(), reach_), phases2 = phasesOf(a.y(), reach_);
  // Two real planes share one transform.
  std::vector<ComplexFloat> pair(count), last(count);
  for (int k2 = -reach_; k2 <= reach_; ++k2) {
    for (int k1 = -reach_; k1 <= reach_; ++k1) {
      const int to1 = m[0] * k1 + m[2] * k2, to2 = m[1] * k1 + m[3] * k2;
      const ComplexFloat phase = productOf(phases1[k1 + reach_], phases2[k2 + reach_]);
      const std::size_t index = frequencyIndex(k2, n_) * n_ + frequencyIndex(k1, n_);
      const ComplexFloat first = at(0, to1, to2), second = at(1, to1, to2);
      pair[index] = productOf(phase, {first.real() - second.imag(), first.imag() + second.real()});
      last[index] = productOf(phase, at(2, to1, to2));
    }
  }
  squareFourier(pair, n_, true);
  squareFourier(last, n_, true);
  Planes planes;
  for (auto& plane : planes) plane.resize(count);
  for (std::size_t p = 0; p < count; ++p) {
    planes[0][p] = pair[p].real();
    planes[1][p] = pair[p].imag();
    planes[2][p] = last[p].real();
  }
  return planes;
}

double CellSpectrum::shareAlong(int h1, int h2) const {
  double sum = 0;
  for (int t = 1; inBand(t * h1, t * h2); ++t) {
    for (int channel = 0; channel < kChannels; ++channel) {
      sum += 2 * std::norm(at(channel, t * h1, t * h2));
    }
  }
  return energy_ > 0 ? sum / energy_ : 0;
}

}  // namespace seamwise
