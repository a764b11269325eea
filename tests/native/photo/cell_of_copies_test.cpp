#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "photo/base/map_inverse.h"
#include "photo/fabric/cell_mean.h"
#include "photo/fabric/copy_fields_fit.h"
#include "photo/fabric/tile_symmetry.h"
#include "photo/photo_samples.h"

namespace seamwise::testing {
namespace {

double lampAt(const Vec2& p) {
  return std::exp(0.5 * (p.x() / 320 - 0.4) - 0.6 * (p.y() / 240) * (p.y() / 240));
}

/// Displacement by creases. [px] Along x at most 1.4 % of the repeat of about 73 px.
Vec2 creaseAt(const Vec2& p) { return {1.0 * std::sin(p.y() / 30), 0.5 * std::cos(p.x() / 40)}; }

CopyFields fieldsOf(const Photo& photo, const LatticeMap& map) {
  const SrgbCurve curve;
  CopyFieldsFit fit(photo.view(), map, curve);
  while (fit.advance()) {
  }
  return fit.fields();
}

/// Root mean square of a channel's error after subtracting its mean.
struct Spread {
  double sum = 0, squares = 0, count = 0;
  void add(double x) { sum += x, squares += x * x, ++count; }
  double rms() const { return std::sqrt(squares / count - sum * sum / count / count); }
};

CellPicture meanOf(const Photo& photo, const LatticeMap& map, const CopyFields& fields, int n,
                   double flatten = 1) {
  CellGrid grid;
  grid.columns = grid.rows = n;
  CellMean mean(photo.view(), 1, map, fields, grid, flatten);
  while (mean.advance(10'000)) {
  }
  return mean.picture();
}

double noiseOf(const CellPicture& cell) {
  double noise = 0;
  for (const float v : cell.noise) noise += v;
  return noise / static_cast<double>(cell.noise.size());
}

/// Peak signal-to-noise ratio against the print itself after a gain for each colour. [dB]
double decibels(const CellPicture& cell) {
  const SrgbCurve curve;
  double squares = 0;
  for (int c = 0; c < 3; ++c) {
    double both = 0, own = 0;
    for (int pass = 0; pass < 2; ++pass) {
      for (int k = 0; k < cell.n * cell.n; ++k) {
        const Vec2 u(static_cast<double>(k % cell.n) / cell.n,
                     static_cast<double>(k / cell.n) / cell.n);
        const double truth = wavyPrint(u)[c], seen = curve.linear(cell.planes[c][k]);
        if (pass == 0)
          both += truth * seen, own += seen * seen;
        else
          squares += std::pow(curve.code(static_cast<float>(truth)) -
                                  curve.code(static_cast<float>(seen * both / own)),
                              2);
      }
    }
  }
  return -10 * std::log10(squares / (3.0 * cell.n * cell.n));
}

CameraView tilted() {
  CameraView view;
  view.tilt = 0.15;
  view.turn = 0.3;
  return view;
}

TEST(PhotoTile, MapsAreInvertedWithTheirLens) {
  LatticeMap map = tilted().map();
  map.lens = -0.04;
  const Vec2 u(1.3, -0.7);
  EXPECT_LT((MapInverse(map)(map(u)) - u).norm(), 1e-9);
}

TEST(PhotoTile, LightIsToldFromThePrint) {
  const LatticeMap map = tilted().map();
  const MapInverse look(map);
  const CopyFields fields = fieldsOf(photographed(320, 240, wavyPrint, look, lampAt, 0.01), map);
  Spread off;
  for (int y = 10; y < 240; y += 20) {
    for (int x = 10; x < 320; x += 20) {
      float light[3];
      fields.light.at(static_cast<float>(x), static_cast<float>(y), light);
      off.add(light[1] - std::log(lampAt(Vec2(x, y))));
    }
  }
  EXPECT_LT(off.rms(), 0.01);  // the light varies by a factor of 2.7
  EXPECT_LT(fields.unevenness, 0.002);
}

TEST(PhotoTile, CreasesAreFollowed) {
  const LatticeMap map = tilted().map();
  const MapInverse inverse(map);
  const auto look = [&](const Vec2& p) { return inverse(p - creaseAt(p)); };
  const CopyFields fields = fieldsOf(photographed(320, 240, wavyPrint, look, lampAt, 0.01), map);
  Spread x_off, y_off;
  for (int y = 10; y < 240; y += 20) {
    for (int x = 10; x < 320; x += 20) {
      float shift[2];
      fields.shift.at(static_cast<float>(x), static_cast<float>(y), shift);
      const Vec2 true_shift = creaseAt(Vec2(x + shift[0], y + shift[1]));
      x_off.add(shift[0] - true_shift.x());
      y_off.add(shift[1] - true_shift.y());
    }
  }
  EXPECT_LT(x_off.rms(), 0.15);  // px, of 0.7
  EXPECT_LT(y_off.rms(), 0.15);  // px, of 0.35
  EXPECT_NEAR(fields.unevenness, 0.78 / cellSize(map), 0.002);
}

TEST(PhotoTile, TheMeanOfCopiesIsThePrint) {
  const LatticeMap map = tilted().map();
  const MapInverse inverse(map);
  const auto look = [&](const Vec2& p) { return inverse(p - creaseAt(p)); };
  const Photo photo = photographed(320, 240, wavyPrint, look, lampAt, 0.02);
  const CopyFields fields = fieldsOf(photo, map);
  const CellPicture cell = meanOf(photo, map, fields, 96);
  EXPECT_GT(decibels(cell), 38);
  // About ten copies with a noise of 0.02 in each colour, summed over the opponent channels.
  const double noise = noiseOf(cell);
  EXPECT_GT(noise, 0.2 * 0.02 * 0.02 * 2.05 / 12);
  EXPECT_LT(noise, 3 * 0.02 * 0.02 * 2.05 / 12);
  EXPECT_GT(noiseOf(meanOf(photo, map, fields, 96, 0)), 5 * noise);  // copies in their own light
}

TEST(PhotoTile, APatchThatDiffersIsLeftOut) {
  const LatticeMap map = tilted().map();
  const MapInverse look(map);
  const auto even = [](const Vec2&) { return 1.0; };
  Photo photo = photographed(320, 240, wavyPrint, look, even, 0.01);
  EXPECT_TRUE(fieldsOf(photo, map).regions.empty());
  for (int y = 60; y < 100; ++y)
    for (int x = 200; x < 250; ++x)
      photo.rgba[4 * (y * 320 + x)] = photo.rgba[4 * (y * 320 + x) + 2] = 0;
  const CopyFields fields = fieldsOf(photo, map);
  ASSERT_EQ(fields.regions.size(), 1u);
  EXPECT_LT((fields.regions[0].low - Vec2(200, 60)).norm(), 40);  // a third of a cell as tolerance
  EXPECT_LT((fields.regions[0].high - Vec2(250, 100)).norm(), 40);
  EXPECT_GT(fields.differing, 0.026);  // includes the patch
  EXPECT_LT(fields.differing, 0.15);
  float weight;
  fields.weight.at(225, 80, &weight);
  EXPECT_EQ(weight, 0);
  EXPECT_GT(decibels(meanOf(photo, map, fields, 96)), 38);
}

TEST(PhotoTile, AnotherBasisAndOriginTurnTheCell) {
  const LatticeMap map = tilted().map();
  const Photo photo = photographed(
      320, 240, wavyPrint, MapInverse(map), [](const Vec2&) { return 1.0; }, 0);
  const CopyFields fields = fieldsOf(photo, map);
  CellGrid grid;
  grid.columns = grid.rows = 48;
  grid.basis << 0, -1, 1, 0;
  grid.origin = Vec2(0.25, 0.5);
  CellMean mean(photo.view(), 1, map, fields, grid, 1);
  while (mean.advance(10'000)) {
  }
  const CellPicture plain = meanOf(photo, map, fields, 48), turned = mean.picture();
  float most = 0;
  for (int j = 0; j < 48; ++j) {
    for (int i = 0; i < 48; ++i) {
      const int a = (48 - j + 12) % 48, b = (i + 24) % 48;
      most = std::max(most, std::abs(turned.planes[0][j * 48 + i] - plain.planes[0][b * 48 + a]));
    }
  }
  EXPECT_LT(most, 0.02);
}

TEST(PhotoTile, ItsImageHasPixelsAsWideAsHigh) {
  const LatticeMap map = CameraView{}.map();
  Mat2 gram;
  gram << 100, 20, 20, 85;
  const CellGrid grid = nativeGrid(map, gram, Mat2::Identity(), Vec2::Zero(), {});
  EXPECT_EQ(grid.columns, 72);  // 75 px, in whole dozens
  EXPECT_EQ(grid.rows, 72);     // 69 px
  const CellGrid least = nativeGrid(map, gram, Mat2::Identity(), Vec2::Zero(), {40});
  EXPECT_EQ(least.columns, 40);
  EXPECT_EQ(least.rows, 37);
  const CellGrid finer = nativeGrid(map, gram, Mat2::Identity(), Vec2::Zero(), {2048, 2});
  EXPECT_EQ(finer.columns, 144);  // 149 px, in whole dozens
  EXPECT_EQ(finer.rows, 144);     // 138 px
}

/// A tile of random pixels, and its mean under the group.
struct Symmetrised {
  explicit Symmetrised(const char* name, int n) {
    Random random(3);
    for (std::vector<float>& plane : planes)
      for (int k = 0; k < n * n; ++k) plane.push_back(static_cast<float>(random.uniform()));
    TileSymmetry tile(planes, n, n, *findGroup(name));
    while (tile.advance(100)) {
    }
    symmetric = tile.planes();
  }
  std::array<std::vector<float>, 3> planes, symmetric;
};

TEST(PhotoTile, TilesAreMadeSymmetricPixelByPixel) {
  const int n = 24;
  const Symmetrised tile("p4g", n);
  for (int k = 0; k < n * n; ++k) {
    const int i = k % n, j = k / n;
    EXPECT_FLOAT_EQ(tile.symmetric[0][k], tile.symmetric[0][i * n + (n - 1 - j)]);  // quarter turn
    const int glide = ((n - 1 - j + n / 2) % n) * n + (i + n / 2) % n;
    EXPECT_FLOAT_EQ(tile.symmetric[0][k], tile.symmetric[0][glide]);
  }
  EXPECT_NE(tile.symmetric[0][0], tile.planes[0][0]);
}

TEST(PhotoTile, TurnsBySixtyDegreesLieBetweenPixels) {
  const int n = 48;
  const Symmetrised once("p6m", n);
  TileSymmetry twice(once.symmetric, n, n, *findGroup("p6m"));
  while (twice.advance(100)) {
  }
  double before = 0, after = 0;
  for (int k = 0; k < n * n; ++k) {
    before += std::pow(once.symmetric[0][k] - once.planes[0][k], 2);
    after += std::pow(twice.planes()[0][k] - once.symmetric[0][k], 2);
  }
  EXPECT_LT(after, 0.05 * before);  // interpolation smooths
}

TEST(PhotoTile, ImagesBeginWithTheirTopRow) {
  std::array<std::vector<float>, 3> planes;
  for (std::vector<float>& plane : planes) plane = {0, 1, 0.5, 0};
  EXPECT_EQ(imageBytes(2, 2, planes),
            (std::vector<std::uint8_t>{128, 128, 128, 255, 0, 0, 0, 255,  //
                                       0, 0, 0, 255, 255, 255, 255, 255}));
}

}  // namespace
}  // namespace seamwise::testing
