#include "photo/lattice/lattice_search.h"

#include <gtest/gtest.h>

#include <complex>

#include "photo/lattice/autocorrelation.h"
#include "photo/lattice/cell_tests.h"
#include "photo/lattice/channels.h"
#include "photo/lattice/hidden_places.h"
#include "photo/photographed_prints.h"

namespace seamwise {
namespace {

using testing::DiscPrint;
using testing::DrawnPicture;
using testing::Ink;
using testing::latticeOnPicture;
using testing::photographed;

Mat2 columns(double x1, double y1, double x2, double y2) {
  return (Mat2() << x1, x2, y1, y2).finished();
}

/// Greatest relative difference of w1 and w2 at the image's middle from the nearest basis of the
/// true lattice; 1 for another lattice.
double errorOf(const LatticeMap& map, const TiltedLattice& truth) {
  const TiltedLattice found = TiltedLattice::of(map);
  const Mat2 index = truth.basis.inverse() * found.basis;
  const Mat2 whole = index.array().round();
  if (std::abs(std::abs(whole.determinant()) - 1) > 1e-9) return 1;
  const Mat2 difference = truth.basis * whole - found.basis;
  return std::max(difference.col(0).norm() / found.basis.col(0).norm(),
                  difference.col(1).norm() / found.basis.col(1).norm());
}

void finish(LatticeSearch& search) {
  while (search.advance()) EXPECT_LE(search.fraction(), 1);
  EXPECT_EQ(search.fraction(), 1);
}

std::string refusal(const DrawnPicture& picture) {
  LatticeSearch search(picture.view());
  finish(search);
  if (!search.error()) return "";
  EXPECT_EQ(search.error()->code, Failure::kPicture);
  return search.error()->message;
}

TEST(LatticeSearch, FindsTheLatticeOfAPrintFromAboveWithinATenthOfAPercent) {
  const DiscPrint print(3);
  const TiltedLattice truth = latticeOnPicture(columns(88, 21, -30, 75));
  const DrawnPicture picture = photographed(truth, [&](const Vec2& u) { return print.at(u); });
  LatticeSearch search(picture.view());
  finish(search);
  ASSERT_FALSE(search.error()) << search.error()->message;
  const LatticeReading& reading = search.result();
  EXPECT_LT(errorOf(reading.map, truth), 0.001);
  EXPECT_EQ(reading.confidence, Confidence::kSure);
  EXPECT_FALSE(reading.is_stripes);
  EXPECT_GT(reading.explained, 0.9);
  EXPECT_GE(reading.copies, 5);
  EXPECT_LT(reading.uncertainty, 0.003);
  EXPECT_LT(TiltedLattice::of(reading.map).basis.determinant(), 0);  // counter-clockwise, y down
}

TEST(LatticeSearch, FindsItOnTiltedFabric) {
  const DiscPrint print(5);
  const TiltedLattice truth = latticeOnPicture(columns(70, -15, 12, 80), Vec2(0.15, -0.1));
  const DrawnPicture picture = photographed(truth, [&](const Vec2& u) { return print.at(u); });
  LatticeSearch search(picture.view());
  finish(search);
  ASSERT_FALSE(search.error()) << search.error()->message;
  EXPECT_LT(errorOf(search.result().map, truth), 0.003);
  EXPECT_LT((TiltedLattice::of(search.result().map).tilt - truth.tilt).norm(), 0.005);
}

TEST(LatticeSearch, TakesTheLargerCellWhenHalvesDifferInColourAlone) {
  const DiscPrint print(7);
  const TiltedLattice truth = latticeOnPicture(columns(110, 10, -8, 70));
  const DrawnPicture picture = photographed(truth, [&](const Vec2& u) {
    const bool is_second = u.x() - std::floor(u.x()) >= 0.5;
    Ink ink = print.at(Vec2(2 * u.x(), u.y()));
    if (is_second) std::swap(ink[0], ink[2]);
    return ink;
  });
  LatticeSearch search(picture.view());
  finish(search);
  ASSERT_FALSE(search.error()) << search.error()->message;
  EXPECT_LT(errorOf(search.result().map, truth), 0.003);
}

TEST(LatticeSearch, ReadsStripesByTheirPeriodAcross) {
  const TiltedLattice truth = latticeOnPicture(columns(60, 25, -25, 60));
  const DrawnPicture picture = photographed(truth, [](const Vec2& u) {
    const double t = u.x() - std::floor(u.x());
    return t < 0.3 ? Ink{0.2, 0.3, 0.7} : t < 0.45 ? Ink{0.9, 0.8, 0.2} : Ink{0.8, 0.8, 0.8};
  });
  LatticeSearch search(picture.view());
  finish(search);
  ASSERT_FALSE(search.error()) << search.error()->message;
  EXPECT_TRUE(search.result().is_stripes);
  EXPECT_GT(search.result().uncertainty, 0);
  EXPECT_LT(search.result().uncertainty, 0.003);
  const Mat2 basis = TiltedLattice::of(search.result().map).basis;
  const Vec2 along = basis.col(1).normalized();
  EXPECT_NEAR(std::abs(cross(along, basis.col(0))) * truth.radius, 65, 0.2);
  EXPECT_NEAR(std::abs(along.dot(truth.basis.col(0).normalized())), 0, 0.003);
}

/// Tells if a tape measure across the image covers a place, and gives the ink of its ticks there.
std::optional<Ink> tapeAt(const Vec2& u) {
  const double across = u.y() - 0.2 * u.x() - 0.3, along = 12 * u.x();
  if (std::abs(across) > 0.14) return std::nullopt;
  const bool is_tick = across > 0 && along - std::floor(along) < 0.3;
  return is_tick ? Ink{0.05, 0.05, 0.05} : Ink{0.95, 0.9, 0.6};
}

TEST(LatticeSearch, FindsTheLatticeUnderATape) {
  const DiscPrint print(3);
  const TiltedLattice truth = latticeOnPicture(columns(88, 21, -30, 75));
  const DrawnPicture picture =
      photographed(truth, [&](const Vec2& u) { return tapeAt(u).value_or(print.at(u)); });
  LatticeSearch search(picture.view());
  finish(search);
  ASSERT_FALSE(search.error()) << search.error()->message;
  EXPECT_LT(errorOf(search.result().map, truth), 0.002);
  EXPECT_EQ(search.result().confidence, Confidence::kSure);
}

TEST(LatticeSearch, FindsTheLatticeOfTheLargerPanelBesideASeam) {
  const DiscPrint print(3);
  const TiltedLattice truth = latticeOnPicture(columns(88, 21, -30, 75));
  const DrawnPicture picture = photographed(truth, [&](const Vec2& u) {
    const bool is_beyond = u.x() + 0.1 * u.y() > 0.9;
    return print.at(is_beyond ? Vec2(u + Vec2(0.4, 0.3)) : u);
  });
  LatticeSearch search(picture.view());
  finish(search);
  ASSERT_FALSE(search.error()) << search.error()->message;
  EXPECT_LT(errorOf(search.result().map, truth), 0.002);
}

TEST(LatticeSearch, RefusesTwoPrintsSideBySide) {
  const DiscPrint left(3), right(4);
  const TiltedLattice lattice = latticeOnPicture(columns(66, 16, -22, 56));
  const Mat2 other = columns(0.7, 0.3, -0.4, 0.8);
  const std::string sentence = refusal(photographed(lattice, [&](const Vec2& u) {
    const bool is_left = (lattice.basis * u).x() < 0;
    return is_left ? left.at(u) : right.at(other * u);
  }));
  EXPECT_NE(sentence.find("another print"), std::string::npos) << sentence;
}

TEST(HiddenPlaces, AreThoseUnderACard) {
  const DiscPrint print(3);
  const TiltedLattice lattice = latticeOnPicture(columns(66, 16, -22, 56));
  const DrawnPicture drawn = photographed(lattice, [&](const Vec2& u) {
    const Vec2 p = lattice.radius * (lattice.basis * u);
    return std::abs(p.x()) < 70 && std::abs(p.y()) < 50 ? Ink{0.9, 0.9, 0.9} : print.at(u);
  });
  Picture picture = reducedFrame(drawn.view(), 1);
  reduceRows(drawn.view(), 1, 0, picture.height, picture);
  flatten(picture, 48);
  const HiddenPlaces hidden = hiddenPlaces(ChannelImage::of(picture), lattice, 20);
  EXPECT_NEAR(hidden.share, 140 * 100 / (400.0 * 300), 0.08);  // blocks beside it are hidden, too
  EXPECT_TRUE(hidden.at(200, 150));
  for (const Vec2& free : {Vec2(40, 40), Vec2(360, 150), Vec2(200, 270)})
    EXPECT_FALSE(hidden.at(static_cast<float>(free.x()), static_cast<float>(free.y())));
  EXPECT_FALSE(hidden.at(static_cast<float>(hidden.free_middle.x()),
                         static_cast<float>(hidden.free_middle.y())));
}

TEST(LatticeSearch, RefusesWhatDoesNotRepeat) {
  // The cell is larger than the image and contains many discs.
  const DiscPrint scattered(11, 80);
  EXPECT_NE(refusal(photographed(latticeOnPicture(columns(640, 0, 0, 640)),
                                 [&](const Vec2& u) { return scattered.at(u); }))
                .find("no repeat was found"),
            std::string::npos);
  EXPECT_NE(refusal(photographed(latticeOnPicture(columns(50, 0, 0, 50)),
                                 [](const Vec2&) {
                                   return Ink{0.8, 0.7, 0.6};
                                 }))
                .find("looks plain"),
            std::string::npos);
}

TEST(LatticeSearch, AsksForMoreWhereTooFewRepeatsAreSeen) {
  const DiscPrint print(3);
  const std::string sentence = refusal(photographed(latticeOnPicture(columns(100, 0, 0, 160)),
                                                    [&](const Vec2& u) { return print.at(u); }));
  EXPECT_NE(sentence.find("step back until three repeats are seen"), std::string::npos) << sentence;
}

TEST(LatticeSearch, AlignsAGivenLatticeOrKeepsIt) {
  const DiscPrint print(3);
  const TiltedLattice truth = latticeOnPicture(columns(88, 21, -30, 75));
  const DrawnPicture picture = photographed(truth, [&](const Vec2& u) { return print.at(u); });
  TiltedLattice guess = truth;
  guess.basis *= 1.02;
  guess.origin = Vec2(0.1, 0.05);
  LatticeSearch aligned(picture.view(), guess.map(), GivenLattice::kAlign);
  finish(aligned);
  ASSERT_FALSE(aligned.error());
  const TiltedLattice found = TiltedLattice::of(aligned.result().map);
  EXPECT_LT((found.basis - truth.basis).norm(), 0.002 * truth.basis.norm());
  EXPECT_LT((found.origin - guess.origin).norm(), 1e-9);
  LatticeSearch kept(picture.view(), guess.map(), GivenLattice::kKeep);
  finish(kept);
  ASSERT_FALSE(kept.error());
  EXPECT_LT((TiltedLattice::of(kept.result().map).basis - guess.basis).norm(), 1e-9);
  EXPECT_LT(kept.result().explained, aligned.result().explained);
}

TEST(Autocorrelation, IsTheSumOfProductsOverTheSumOfWeights) {
  WeightedPlanes planes;
  planes.width = 13;
  planes.height = 9;
  Random random(4);
  for (int i = 0; i < planes.width * planes.height; ++i) {
    planes.first.push_back(static_cast<float>(random.uniform() - 0.5));
    planes.second.push_back(static_cast<float>(random.uniform() - 0.5));
    planes.weight.push_back(1);
  }
  const Autocorrelation fast = autocorrelation(planes, 5, 4, 0);
  const auto product = [&](int dx, int dy) {
    double sum = 0;
    for (int y = std::max(0, -dy); y < planes.height - std::max(0, dy); ++y) {
      for (int x = std::max(0, -dx); x < planes.width - std::max(0, dx); ++x) {
        const int i = y * planes.width + x, j = (y + dy) * planes.width + x + dx;
        sum += planes.first[i] * planes.first[j] + planes.second[i] * planes.second[j];
      }
    }
    return sum;
  };
  for (int y = 0; y < 4; ++y) {
    for (int x = -4; x <= 4; ++x) {
      const std::size_t i = y * fast.columns() + x + fast.reach_x;
      EXPECT_NEAR(fast.r[i] * fast.overlap[i], product(x, y) / product(0, 0), 1e-5)
          << "shift " << x << ", " << y;
    }
  }
}

TEST(LatticeFit, HasTheDerivativeThatDifferencesSay) {
  const DiscPrint print(9, 5);
  TiltedLattice truth = latticeOnPicture(columns(90, 20, -25, 80), Vec2(0.1, 0.05));
  const DrawnPicture drawn = photographed(truth, [&](const Vec2& u) { return print.at(u); });
  Picture picture = reducedFrame(drawn.view(), 1);
  reduceRows(drawn.view(), 1, 0, picture.height, picture);
  flatten(picture, 48);
  for (auto& plane : picture.planes) plane = blurred(plane, picture.width, picture.height, 3);
  const ChannelImage image = ChannelImage::of(picture);
  TiltedLattice view = truth;
  view.basis *= 1.01;
  view.lens = 0.02;
  const CellList cells{{-1, -1}, {0, -1}, {-1, 0}, {0, 0}};  // all inside the image
  const auto linearisedAt = [&](const TiltedLattice& at) {
    return linearised(sampleCopies(image, at, cells, 16, true), at);
  };
  const FitStep step = linearisedAt(view);
  for (int k = 0; k < 7; ++k) {
    const double h = 2e-5;
    std::array<double, 2> sums{};
    for (int side = 0; side < 2; ++side) {
      TiltedLattice moved = view;
      double* unknown = k < 4   ? &moved.basis(k / 2, k % 2)
                        : k < 6 ? &moved.tilt[k - 4]
                                : &moved.lens;
      *unknown += side == 0 ? -h : h;
      sums[side] = linearisedAt(moved).sum;
    }
    const double difference = (sums[1] - sums[0]) / (2 * h) / 2;
    EXPECT_NEAR(step.gradient[k], difference,
                0.03 * std::abs(difference) + 0.002 * step.normal[k][k])
        << "unknown " << k;
  }
}

TEST(CellTests, KnowEveryLargerCellOfAnIndex) {
  EXPECT_EQ(largerCells(2).size(), 3U);
  EXPECT_EQ(largerCells(3).size(), 4U);
  EXPECT_EQ(largerCells(6).size(), 12U);
  for (const Mat2& m : largerCells(6)) EXPECT_EQ(m.determinant(), 6);
}

}  // namespace
}  // namespace seamwise
