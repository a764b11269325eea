#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/random.h"
#include "geometry/vec2.h"
#include "photo/base/lattice_map.h"
#include "photo/base/picture.h"
#include "photo/fabric/srgb.h"

namespace seamwise::testing {

/// A print without any symmetry, in linear light, as a function of lattice coordinates: a few
/// waves.
inline std::array<double, 3> wavyPrint(const Vec2& u) {
  const auto wave = [&](int a, int b, double phase) {
    return std::sin(2 * kPi * (a * u.x() + b * u.y() + phase));
  };
  const double one = wave(1, 0, 0.1) + 0.7 * wave(2, 3, 0.3),
               two = wave(0, 1, 0.2) - wave(3, -1, 0);
  return {0.4 + 0.12 * one, 0.4 + 0.1 * two, 0.35 + 0.06 * (one + two)};
}

/// Camera above flat fabric: tilted about x, turned in the fabric's plane, `distance` cm away,
/// focal length f px, the lattice's origin in the middle.
struct CameraView {
  int width = 320, height = 240;
  double f = 300, distance = 40, tilt = 0, turn = 0;
  Vec2 w1{10, 0}, w2{2, 9};  ///< cm

  LatticeMap map() const {
    const double c = std::cos(tilt), s = std::sin(tilt);
    Mat3 place;
    for (int k = 0; k < 2; ++k) {
      const Vec2 w = rotation(turn) * (k == 0 ? w1 : w2);
      place.col(k) = Vec3(w.x(), -c * w.y(), s * w.y());
    }
    place.col(2) = Vec3(0, 0, distance);
    LatticeMap map;
    map.middle = Vec2(width / 2.0, height / 2.0);
    map.radius = width / 2.0;
    Mat3 camera;
    camera << f, 0, map.middle.x(), 0, f, map.middle.y(), 0, 0, 1;
    map.homography = camera * place;
    return map;
  }
};

/// Bytes for a PixelView.
struct Photo {
  int width, height;
  std::vector<std::uint8_t> rgba;
  PixelView view() const { return {width, height, rgba}; }
};

/// Photographs `print` in a given light, distorted by creases, with uniform noise.
/// @param look   lattice coordinates seen at a point of the image
/// @param light  brightness at a point of the image
template <class Print, class Look, class Light>
Photo photographed(int width, int height, Print&& print, Look&& look, Light&& light, double noise) {
  Photo photo{width, height,
              std::vector<std::uint8_t>(4 * static_cast<std::size_t>(width) * height, 255)};
  const SrgbCurve curve;
  Random random(7);
  std::size_t k = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x, k += 4) {
      const Vec2 p(x + 0.5, y + 0.5);
      const std::array<double, 3> colour = print(look(p));
      for (int c = 0; c < 3; ++c) {
        const double code = curve.code(static_cast<float>(colour[c] * light(p))) +
                            noise * 2 * std::sqrt(3.0) * (random.uniform() - 0.5);
        photo.rgba[k + c] = static_cast<std::uint8_t>(std::clamp(255 * code + 0.5, 0.0, 255.0));
      }
    }
  }
  return photo;
}

}  // namespace seamwise::testing
