#include "photo/tile/tile_reading.h"

#include <gtest/gtest.h>

#include "photo/cell_samples.h"
#include "photo/print_picture.h"
#include "support/print_samples.h"

namespace seamwise {
namespace {

using testing::CellView;
using testing::drawnCell;
using testing::printPicture;
using testing::sampleGroup;
using testing::samplePrint;
using Chance = seamwise::Random;

/// Pixels of a tile, with a view of them for readers.
struct TilePixels {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
  PixelView view() const { return {width, height, rgba}; }
};

/// Reduces the pixels by means over 4 x 4 of them.
TilePixels pixelsOf(const Picture& fine) {
  constexpr int kTimes = 4;
  TilePixels tile{fine.width / kTimes, fine.height / kTimes, {}};
  for (int y = 0; y < tile.height; ++y) {
    for (int x = 0; x < tile.width; ++x) {
      for (const auto& plane : fine.planes) {
        float sum = 0;
        for (int k = 0; k < kTimes * kTimes; ++k) {
          sum += plane[(y * kTimes + k / kTimes) * fine.width + x * kTimes + k % kTimes];
        }
        tile.rgba.push_back(static_cast<std::uint8_t>(std::lround(255 * sum / kTimes / kTimes)));
      }
      tile.rgba.push_back(255);
    }
  }
  return tile;
}

/// Part of a tile that repeats edge to edge, in quarter turns.
TilePixels partOf(const TilePixels& tile, int x0, int y0, int width, int height) {
  TilePixels part{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int at = (y + y0) % tile.height * tile.width + (x + x0) % tile.width;
      part.rgba.insert(part.rgba.end(), tile.rgba.begin() + 4 * at, tile.rgba.begin() + 4 * at + 4);
    }
  }
  return part;
}

TilePixels turned(const TilePixels& tile) {
  TilePixels out{tile.height, tile.width, std::vector<std::uint8_t>(tile.rgba.size())};
  for (int y = 0; y < tile.height; ++y) {
    for (int x = 0; x < tile.width; ++x) {
      const int to = x * tile.height + (tile.height - 1 - y);
      std::copy_n(tile.rgba.begin() + 4 * (y * tile.width + x), 4, out.rgba.begin() + 4 * to);
    }
  }
  return out;
}

/// A rectangle of a group's print, about `pixels` wide, that repeats edge to edge.
TilePixels tileOf(const GroupData& group, int pixels, unsigned seed) {
  Chance chance(seed);
  const WallpaperGroup sample = sampleGroup(group);
  CellView view;
  view.origin = {0.23, 0.41};
  const CellPicture cell = drawnCell(samplePrint(sample, chance), view, 4);
  Mat2 sides = Mat2::Identity();
  if (group.lattice == LatticeType::kRhombic) sides << 1, -1, 1, 1;
  if (group.lattice == LatticeType::kHexagonal) sides << 1, -1, 0, 2;
  const Mat2 basis = (Mat2() << sample.w1(), sample.w2()).finished() * sides;
  const double ratio = basis.col(1).norm() / basis.col(0).norm();
  const int rows = static_cast<int>(std::lround(ratio * pixels));
  return pixelsOf(printPicture(cell, sides, Vec2::Zero(), 4 * pixels, 4 * rows));
}

TileReader readTile(const PixelView& tile, bool any_edges = false) {
  TileReader reader(tile, any_edges);
  while (reader.advance()) {
  }
  return reader;
}

std::string_view bestName(const TileReader& reader) {
  const GroupReading& groups = reader.reading().groups;
  return groups.groups[groups.best].group->name;
}

class ReadTile : public ::testing::TestWithParam<GroupData> {};
INSTANTIATE_TEST_SUITE_P(TileReading, ReadTile, ::testing::ValuesIn(testing::sampledGroups()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(ReadTile, HasItsGroupWhereverItBeginsAndHoweverItIsTurned) {
  const TilePixels tile = tileOf(GetParam(), 96, 4);
  const TilePixels moved = turned(partOf(tile, 17, 40, tile.width, tile.height));
  const auto reading = readTile(moved.view());
  ASSERT_FALSE(reading.error()) << reading.error()->message;
  EXPECT_EQ(bestName(reading), GetParam().name);
  const bool is_centred =
      GetParam().lattice == LatticeType::kRhombic || GetParam().lattice == LatticeType::kHexagonal;
  EXPECT_EQ(reading.reading().lattice.copies, is_centred ? 2 : 1);
  const double area = moved.width * moved.height / (is_centred ? 2.0 : 1.0);
  EXPECT_NEAR(std::sqrt(reading.reading().gram.determinant()), area, 1e-6 * area);
}

TEST(TileReading, FindsTheCellOfAPictureOfSeveral) {
  const TilePixels tile = tileOf(*findGroup("pgg"), 48, 8);
  const auto reading = readTile(partOf(tile, 5, 9, 3 * tile.width, 2 * tile.height).view());
  ASSERT_FALSE(reading.error()) << reading.error()->message;
  EXPECT_EQ(reading.reading().lattice.copies, 6);
  EXPECT_EQ(bestName(reading), "pgg");
}

TEST(TileReading, NamesTheEdgesThatDoNotMeet) {
  const TilePixels tile = tileOf(*findGroup("p2"), 120, 6);
  const auto narrow = readTile(partOf(tile, 31, 12, tile.width - 1, tile.height).view());
  ASSERT_TRUE(narrow.error());
  EXPECT_NE(narrow.error()->message.find("left and right differ here"), std::string::npos);
  const auto low = readTile(partOf(tile, 31, 12, tile.width, tile.height - 1).view());
  ASSERT_TRUE(low.error());
  EXPECT_NE(low.error()->message.find("top and bottom differ here"), std::string::npos);
  const auto half = readTile(partOf(tile, 31, 12, tile.width / 2, tile.height).view());
  EXPECT_TRUE(half.error());
}

TEST(TileReading, FindsALineCutFromWhereMotifsAreMirrored) {
  // edges continue into each other there, but quarter turns no longer fit
  CellView view;
  Chance chance(2);
  const CellPicture cell = drawnCell(samplePrint(sampleGroup(*findGroup("p4m")), chance), view, 4);
  const TilePixels tile = pixelsOf(printPicture(cell, Mat2::Identity(), Vec2::Zero(), 480, 480));
  ASSERT_FALSE(readTile(tile.view()).error());
  EXPECT_TRUE(readTile(partOf(tile, 0, 0, 119, 120).view()).error());
}

TEST(TileReading, FindsALineCutFromFlatBands) {
  // bands of 24, 40, 8 and 40 pixels, mirrored on both sides of 32 in the middle of the image
  TilePixels tile{256, 256, {}};
  const auto band = [](int x) {
    const int k = std::min(x, 255 - x);
    return k < 24 ? 60 : k < 64 ? 200 : k < 72 ? 120 : k < 112 ? 220 : 90;
  };
  for (int y = 0; y < 256; ++y) {
    for (int x = 0; x < 256; ++x) {
      const auto value = static_cast<std::uint8_t>((band(x) + band((y + 19) % 256)) / 2);
      tile.rgba.insert(tile.rgba.end(), {value, value, value, 255});
    }
  }
  EXPECT_FALSE(readTile(tile.view()).error());
  const auto narrow = readTile(partOf(tile, 0, 0, 255, 256).view());
  ASSERT_TRUE(narrow.error());
  EXPECT_NE(narrow.error()->message.find("one column of pixels"), std::string::npos);
}

TEST(TileReading, SaysHowAPictureMeetsItsCopiesWhereThatIsAsked) {
  const TilePixels tile = tileOf(*findGroup("p1"), 96, 6);
  const auto whole = readTile(tile.view(), true);
  ASSERT_FALSE(whole.error());
  EXPECT_TRUE(whole.seams().across.meets && whole.seams().up.meets);
  EXPECT_TRUE(whole.seams().across.open.empty());
  const auto half = readTile(partOf(tile, 0, 0, tile.width / 2, tile.height).view(), true);
  ASSERT_FALSE(half.error());
  EXPECT_FALSE(half.seams().across.meets);
  EXPECT_FALSE(half.seams().across.open.empty());
  EXPECT_TRUE(half.seams().up.meets);
}

TEST(TileReading, GoesOnInSmallSteps) {
  const TilePixels tile = tileOf(*findGroup("p1"), 256, 6);
  TileReader reader(tile.view(), false);
  int steps = 0, of_groups = 0;
  double fraction = 0;
  while (reader.advance()) {
    ++steps;
    of_groups += reader.readsGroups() ? 1 : 0;
    EXPECT_GE(reader.fraction(), fraction);
    fraction = reader.fraction();
  }
  EXPECT_GE(steps - of_groups, 4);  // steps for two edges and the cell
  EXPECT_GT(of_groups, 17);         // groups one by one, and those of the image with one more line
  EXPECT_FALSE(reader.advance());
  EXPECT_EQ(reader.fraction(), 1);
}

TEST(TileReading, AsksForMorePixels) {
  const TilePixels tile = tileOf(*findGroup("p1"), 96, 6);
  const auto reading = readTile(partOf(tile, 0, 0, 5, 96).view());
  ASSERT_TRUE(reading.error());
  EXPECT_EQ(reading.error()->message,
            "the picture has only 5 x 96 pixels: give one of at least 8 each way");
}

}  // namespace
}  // namespace seamwise
