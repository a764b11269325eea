#include "photo/symmetry/group_reading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "photo/cell_samples.h"
#include "photo/fabric/tile_symmetry.h"
#include "photo/print_picture.h"
#include "support/print_samples.h"

namespace seamwise {
namespace {

using testing::anyView;
using testing::CellView;
using testing::drawnCell;
using testing::gramOf;
using testing::photographedCell;
using testing::printPicture;
using testing::sampleGroup;
using testing::SamplePrint;
using testing::samplePrint;
using Chance = seamwise::Random;

GroupReading readGroups(const CellPicture& cell, const Mat2& gram, double tolerance) {
  GroupReader reader(cell, gram, tolerance);
  while (reader.advance()) {
  }
  return reader.result();
}

std::string_view bestName(const GroupReading& reading) {
  return reading.groups[reading.best].group->name;
}

const GroupVerdict& verdictOf(const GroupReading& reading, std::string_view name) {
  for (const GroupVerdict& verdict : reading.groups) {
    if (verdict.group->name == name) return verdict;
  }
  ADD_FAILURE() << name;
  return reading.groups[0];
}

double rootMeanSquare(const std::array<std::vector<float>, 3>& a,
                      const std::array<std::vector<float>, 3>& b) {
  double sum = 0;
  for (int c = 0; c < 3; ++c) {
    for (std::size_t p = 0; p < a[c].size(); ++p) {
      const double d = a[c][p] - b[c][p];
      sum += d * d;
    }
  }
  return std::sqrt(sum / (3.0 * static_cast<double>(a[0].size())));
}

/// The cell on the group's own basis and origin, pixel (i, j) at ((i + 1/2) / n, (j + 1/2) / n).
std::array<std::vector<float>, 3> rebased(const CellPicture& cell, const GroupVerdict& verdict,
                                          int n) {
  const auto& [a, b, c, d] = verdict.basis;
  const Mat2 basis = (Mat2() << a, b, c, d).finished();
  auto planes = printPicture(cell, basis, verdict.origin, n, n).planes;
  for (auto& plane : planes) {  // the first row was the upper one
    for (int j = 0; j < n / 2; ++j)
      std::swap_ranges(&plane[j * n], &plane[j * n] + n, &plane[(n - 1 - j) * n]);
  }
  return planes;
}

class ReadGroup : public ::testing::TestWithParam<GroupData> {};
INSTANTIATE_TEST_SUITE_P(GroupReading, ReadGroup, ::testing::ValuesIn(testing::sampledGroups()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(ReadGroup, IsFoundInAnyBasisAndFromAnyOriginThroughCreasesBlurAndNoise) {
  Chance chance(5 + GetParam().name.size() + 31 * GetParam().name.back());
  const SamplePrint print = samplePrint(sampleGroup(GetParam()), chance);
  CellView view = anyView(chance);
  view.displaced = 0.002;
  view.blur = 1;
  view.shade = 0.01;
  view.noise = 0.01;
  const CellPicture cell = photographedCell(drawnCell(print, view), view, chance);
  const GroupReading reading = readGroups(cell, gramOf(print, view), 0.01);
  ASSERT_EQ(reading.groups.size(), 17u);
  EXPECT_EQ(bestName(reading), GetParam().name);
  const auto elements = cosets(GetParam());
  const bool has_half_turn = std::any_of(elements.begin(), elements.end(), [](const auto& e) {
    return e.m == std::array<int, 4>{-1, 0, 0, -1};
  });
  EXPECT_EQ(reading.one_way, !has_half_turn);
  EXPECT_FALSE(reading.stripes);
}

TEST_P(ReadGroup, FindsBasisAndOriginAboutWhichTheCellIsSymmetric) {
  Chance chance(11 + 17 * GetParam().name.size() + GetParam().name.back());
  const SamplePrint print = samplePrint(sampleGroup(GetParam()), chance);
  CellView view = anyView(chance);
  view.n = 75;
  const CellPicture cell = photographedCell(drawnCell(print, view), view, chance);
  const GroupReading reading = readGroups(cell, gramOf(print, view), 0.01);
  ASSERT_EQ(bestName(reading), GetParam().name);
  const GroupVerdict& verdict = reading.groups[reading.best];
  const int n = 76;
  const auto own = rebased(cell, verdict, n);
  TileSymmetry symmetry(own, n, n, GetParam());
  while (symmetry.advance(1000)) {
  }
  // The print's contrast is about 0.2. The rest comes from edges a fraction of a sample wide and
  // from sixths of a turn, which fall between pixels.
  EXPECT_LT(rootMeanSquare(own, symmetry.planes()), 0.025);
}

/// Bands across u and across v in shares of the cell, which cross like those of a plaid.
CellPicture plaid(const std::vector<double>& across, const std::vector<double>& up, int n = 96) {
  CellPicture cell;
  cell.n = n;
  const auto tone = [n](const std::vector<double>& bands, int i) {
    double at = 0;
    for (std::size_t k = 0; k < bands.size(); ++k) {
      at += bands[k] * n;
      if (i < at) return static_cast<float>(k % 3) / 3;
    }
    return 0.0f;
  };
  for (auto& plane : cell.planes) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) plane.push_back((tone(across, i) + tone(up, j)) / 2);
    }
  }
  cell.noise.assign(n * n, 1e-6f);
  return cell;
}

TEST(GroupReading, ClaimsNoSymmetryOfAnUnevenPlaid) {
  const std::vector<double> uneven{0.5, 0.1875, 0.125, 0.1875};
  const Mat2 square = Mat2::Identity();
  const Mat2 oblong = Vec2(1, 1.5).asDiagonal();
  EXPECT_EQ(bestName(readGroups(plaid(uneven, uneven), oblong, 0.01)), "p1");
  EXPECT_EQ(bestName(readGroups(plaid(uneven, uneven), square, 0.01)), "cm");
  EXPECT_TRUE(readGroups(plaid(uneven, uneven), square, 0.01).one_way);
  EXPECT_EQ(bestName(readGroups(plaid(uneven, {0.5, 0.25, 0.25, 0}), oblong, 0.01)), "p1");
  EXPECT_EQ(bestName(readGroups(plaid(uneven, {0.5, 0.5}), oblong, 0.01)), "pm");
  EXPECT_EQ(bestName(readGroups(plaid({0.5, 0.5}, {0.75, 0.25}), square, 0.01)), "pmm");
  EXPECT_EQ(bestName(readGroups(plaid({0.5, 0.5}, {0.5, 0.5}), square, 0.01)), "p4m");
  EXPECT_EQ(bestName(readGroups(plaid({0.5, 0.5}, {0.5, 0.5}), oblong, 0.01)), "pmm");
}

TEST(GroupReading, KnowsWhatALatticeCannotCarry) {
  const Mat2 oblique = (Mat2() << 1, 0.3, 0.3, 1.4).finished();
  const GroupReading reading = readGroups(plaid({0.5, 0.5}, {0.5, 0.5}), oblique, 0.01);
  EXPECT_EQ(verdictOf(reading, "p4m").verdict, SymmetryVerdict::kCannot);
  EXPECT_EQ(verdictOf(reading, "pm").verdict, SymmetryVerdict::kCannot);
  EXPECT_EQ(bestName(reading), "p2");
}

TEST(GroupReading, TakesEvenAndUnevenStripesInAnyDirectionOfAnyLattice) {
  const Mat2 oblique = (Mat2() << 1, 0.3, 0.3, 1.4).finished();
  for (const bool even : {true, false}) {
    const CellPicture upright =
        even ? plaid({0.5, 0.5}, {1}) : plaid({0.5, 0.1875, 0.125, 0.1875}, {1});
    CellPicture slanted = upright;
    for (int c = 0; c < 3; ++c) {
      for (int j = 0; j < 96; ++j) {
        for (int i = 0; i < 96; ++i) {
          slanted.planes[c][j * 96 + i] = upright.planes[c][(i + j) % 96];
        }
      }
    }
    for (const CellPicture& cell : {upright, slanted}) {
      const GroupReading reading = readGroups(cell, oblique, 0.01);
      EXPECT_TRUE(reading.stripes);
      EXPECT_EQ(bestName(reading), even ? "pmm" : "pm");
      EXPECT_EQ(reading.one_way, !even);
      const int n = 24;
      const auto own = rebased(cell, reading.groups[reading.best], n);
      for (int j = 1; j < n; ++j) EXPECT_NEAR(own[0][j * n + 7], own[0][7], 1e-5);
    }
  }
}

TEST(GroupReading, TestsOneGroupAtATimeSoThatItCanBeCancelled) {
  GroupReader reader(plaid({0.5, 0.5}, {0.75, 0.25}), Mat2::Identity(), 0.01);
  EXPECT_EQ(reader.fraction(), 0);
  for (std::size_t tested = 1; reader.advance(); ++tested) {
    EXPECT_DOUBLE_EQ(reader.fraction(), static_cast<double>(tested) / 17);
  }
  EXPECT_EQ(reader.fraction(), 1);
  EXPECT_FALSE(reader.advance());
  EXPECT_EQ(bestName(reader.result()), "pmm");
}

TEST(GroupReading, SeesThatOneMotifOfManyBreaksAGroup) {
  Chance chance(3);
  SamplePrint print = samplePrint(sampleGroup(*findGroup("pmm")), chance);
  CellView view;
  CellPicture fine = drawnCell(print, view);
  // an extra leaf in one of the four quarters
  SamplePrint single = print;
  single.group = sampleGroup(*findGroup("p1"));
  single.ground = {0, 0, 0};
  single.motifs = {{Vec2(3, 2), Vec2(0.8, 0.3), 0.5, 0, {1, 1, 1}}};
  single.group = WallpaperGroup::make("p1", print.group.w1(), print.group.w2()).value();
  const CellPicture leaf = drawnCell(single, view);
  for (int c = 0; c < 3; ++c) {
    for (std::size_t p = 0; p < leaf.planes[c].size(); ++p) {
      if (leaf.planes[c][p] > 0.5f) fine.planes[c][p] = c == 0 ? 0.95f : 0.05f;
    }
  }
  const CellPicture cell = photographedCell(fine, view, chance);
  const GroupReading reading = readGroups(cell, gramOf(print, view), 0.01);
  EXPECT_NE(verdictOf(reading, "pmm").verdict, SymmetryVerdict::kHas);
  EXPECT_EQ(bestName(reading), "p1");
}

TEST(GroupReading, IsUncertainOfPlainFabric) {
  CellPicture cell = plaid({1}, {1});
  Chance chance(9);
  for (auto& plane : cell.planes) {
    for (float& x : plane) x += static_cast<float>(0.01 * testing::symmetric(chance));
  }
  cell.noise.assign(cell.noise.size(), 3.3e-5f * 2.05f);
  EXPECT_EQ(readGroups(cell, Mat2::Identity(), 0.01).confidence, Confidence::kUncertain);
}

TEST(GroupReading, HasAnOriginInOneColourWithoutNoise) {
  CellPicture cell = plaid({1}, {1});
  for (auto& plane : cell.planes) std::fill(plane.begin(), plane.end(), 0.5f);
  std::fill(cell.noise.begin(), cell.noise.end(), 0.0f);
  for (const GroupVerdict& verdict : readGroups(cell, Mat2::Identity(), 0.01).groups) {
    EXPECT_TRUE(std::isfinite(verdict.origin.x())) << verdict.group->name;
    EXPECT_TRUE(std::isfinite(verdict.origin.y())) << verdict.group->name;
  }
}

}  // namespace
}  // namespace seamwise
