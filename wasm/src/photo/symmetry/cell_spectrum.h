#pragma once
#include <array>
#include <vector>

#include "photo/base/cell_picture.h"
#include "photo/base/fourier.h"

namespace seamwise {

/// Integer matrix, row by row: (u, v) -> (m[0] u + m[1] v, m[2] u + m[3] v).
using IntegerMatrix = std::array<int, 4>;

/// Cell softened equally in all directions of the fabric, without its mean, and its Fourier series:
/// T(u) = sum of F(k) exp(2 pi I k . u). A symmetry u -> M u + a of the lattice permutes the series
/// and turns its phases, F'(k) = F(M^T k) exp(-2 pi I k . a). Images of the cell therefore need no
/// interpolation, whatever the shift.
class CellSpectrum {
 public:
  static constexpr int kChannels = 3;
  using Planes = std::array<std::vector<float>, kChannels>;

  /// @param gram   Gram matrix of the cell's w1, w2, in any unit of area
  CellSpectrum(const CellPicture& cell, const Mat2& gram);

  int n() const { return n_; }
  /// Gram matrix of the basis for a cell of area 1.
  const Mat2& gram() const { return gram_; }
  /// Mean square of the pattern, summed over channels: with noise, and of the noise alone.
  double energy() const { return energy_; }
  double noiseEnergy() const { return noise_energy_; }
  /// Noise variance of the softened samples, summed over channels.
  const std::vector<float>& noise() const { return noise_; }
  /// Luminance and two colour differences, softened.
  const Planes& planes() const { return planes_; }

  /// Returns the mean over the cell of T(u) T'(u), T' the image of the cell under u -> m u + a, for
  /// all shifts a = (i, j) / (2 n), at j * 2 n + i.
  std::vector<float> correlation(const IntegerMatrix& m) const;
  /// Returns the cell's image under u -> m u + a.
  Planes image(const IntegerMatrix& m, const Vec2& a) const;
  /// Returns the share of the energy at multiples of the frequency h.
  double shareAlong(int h1, int h2) const;

 private:
  ComplexFloat at(int channel, int k1, int k2) const;
  bool inBand(int k1, int k2) const { return std::abs(k1) <= reach_ && std::abs(k2) <= reach_; }

  int n_, reach_;  ///< frequencies range from -reach_ to reach_
  Mat2 gram_;
  std::array<std::vector<ComplexFloat>, kChannels> series_;
  Planes planes_;
  std::vector<float> noise_;
  double energy_ = 0, noise_energy_ = 0;
};

}  // namespace seamwise
