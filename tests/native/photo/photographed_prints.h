#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/random.h"
#include "photo/base/map_inverse.h"
#include "photo/base/picture.h"
#include "photo/lattice/tilted_lattice.h"

namespace seamwise::testing {

using Ink = std::array<double, 3>;

/// Discs of some inks in a cell, wrapped around it: a print without symmetry.
class DiscPrint {
 public:
  explicit DiscPrint(std::uint64_t seed, int discs = 9) {
    seamwise::Random random(seed);
    const auto ink = [&] { return Ink{random.uniform(), random.uniform(), random.uniform()}; };
    ground_ = ink();
    for (int k = 0; k < discs; ++k)
      discs_.push_back(
          {Vec2(random.uniform(), random.uniform()), 0.06 + 0.12 * random.uniform(), ink()});
  }

  Ink at(const Vec2& u) const {
    Ink ink = ground_;
    for (const auto& disc : discs_) {
      Vec2 off = u - disc.middle;
      off -= Vec2(off.array().round());
      // A soft rim, so that no sample is ambiguous between two inks.
      const double inside = std::clamp((disc.radius - off.norm()) / 0.03 + 0.5, 0.0, 1.0);
      for (int c = 0; c < 3; ++c) ink[c] += inside * (disc.ink[c] - ink[c]);
    }
    return ink;
  }

 private:
  struct Disc {
    Vec2 middle;
    double radius;
    Ink ink;
  };
  Ink ground_;
  std::vector<Disc> discs_;
};

/// An image in memory, of 400 x 300 pixels.
struct DrawnPicture {
  static constexpr int kWidth = 400, kHeight = 300;
  std::vector<std::uint8_t> rgba = std::vector<std::uint8_t>(4 * kWidth * kHeight, 255);
  PixelView view() const { return {kWidth, kHeight, rgba}; }
};

/// A lattice about the middle of such an image.
/// @param basis   w1, w2 there, as columns. [px]
inline TiltedLattice latticeOnPicture(const Mat2& basis, const Vec2& tilt = Vec2::Zero()) {
  TiltedLattice lattice;
  lattice.middle = Vec2(DrawnPicture::kWidth, DrawnPicture::kHeight) / 2;
  lattice.radius = DrawnPicture::kWidth / 2.0;
  lattice.basis = basis / lattice.radius;
  lattice.tilt = tilt;
  return lattice;
}

/// Draws the inks of `inkAt` at lattice coordinates, in light that falls off to the right, with
/// noise.
template <class InkAt>
DrawnPicture photographed(const TiltedLattice& lattice, const InkAt& inkAt) {
  DrawnPicture picture;
  const MapInverse latticeAt(lattice.map());
  seamwise::Random random(1);
  std::size_t i = 0;
  for (int y = 0; y < DrawnPicture::kHeight; ++y) {
    for (int x = 0; x < DrawnPicture::kWidth; ++x, ++i) {
      const Ink ink = inkAt(latticeAt(Vec2(x + 0.5, y + 0.5)));
      const double light = 0.9 - 0.3 * x / DrawnPicture::kWidth;
      for (int c = 0; c < 3; ++c) {
        const double noise = 0.03 * (random.uniform() + random.uniform() - 1);
        picture.rgba[4 * i + c] =
            static_cast<std::uint8_t>(std::clamp(255 * (light * ink[c] + noise), 0.0, 255.0));
      }
    }
  }
  return picture;
}

}  // namespace seamwise::testing
