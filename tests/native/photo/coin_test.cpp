#include "photo/fabric/coin.h"

#include <gtest/gtest.h>

#include <cmath>

#include "photo/base/map_inverse.h"
#include "photo/photo_samples.h"
#include "support/level.h"

namespace seamwise::testing {
namespace {

CameraView closeUp() {
  CameraView view;
  view.width = 480;
  view.height = 360;
  view.f = 450;
  view.tilt = 0.25;
  view.turn = 0.4;
  return view;
}

const Vec2 kMiddle(2, 1);  // centre of the object. [cm]

/// Photographs a wavy print with a grey object on it.
/// @param covers  whether the object covers a point, in cm from kMiddle
template <class Covers>
Photo withObject(Covers&& covers) {
  const CameraView view = closeUp();
  const MapInverse inverse(view.map());
  const auto print = [&](const Vec2& u) {
    const Vec2 off = u.x() * view.w1 + u.y() * view.w2 - kMiddle;
    return covers(off) ? std::array<double, 3>{0.75, 0.73, 0.7} : wavyPrint(u);
  };
  return photographed(
      480, 360, print, inverse, [](const Vec2&) { return 1.0; }, 0.01);
}

/// Runs the search to its end.
Outcome<FoundObject> outcomeOf(ObjectSearch& search) {
  while (search.advance()) {
  }
  if (search.error()) return *search.error();
  return search.found();
}

Outcome<FoundObject> found(const Photo& photo, int object, const Vec2& beside) {
  const CameraView view = closeUp();
  Mat2 w, gram;
  w.col(0) = view.w1;
  w.col(1) = view.w2;
  gram = w.transpose() * w / 9;  // unit 3 cm
  const double area = cross(view.w1, view.w2);
  const Vec2 p = kMiddle + beside;
  const Vec2 u(cross(p, view.w2) / area, cross(view.w1, p) / area);
  ObjectSearch search(photo.view(), view.map(), gram, knownObjects()[object], view.map()(u));
  return outcomeOf(search);
}

TEST(PhotoCoin, ACoinTellsTheScaleUnderTilt) {
  const Photo photo = withObject([](const Vec2& off) { return off.norm() < 2.325 / 2; });
  for (const Vec2& beside : testing::sampleOf<Vec2>(1, {Vec2(0.3, -0.2), Vec2(0, 0)})) {
    const Outcome<FoundObject> coin = found(photo, 0, beside);
    ASSERT_TRUE(coin.ok());
    EXPECT_NEAR(coin.value().scale, 3, 0.03);
    EXPECT_LT(coin.value().error, 0.02);
  }
}

TEST(PhotoCoin, ARingWithinIsNotTakenForTheRim) {
  const Photo photo = withObject([](const Vec2& off) {
    return off.norm() < 2.575 / 2 && (off.norm() > 0.95 || off.norm() < 0.85);
  });
  const Outcome<FoundObject> coin = found(photo, 1, Vec2(0.1, 0.1));
  ASSERT_TRUE(coin.ok());
  EXPECT_NEAR(coin.value().scale, 3, 0.03);
}

TEST(PhotoCoin, ACardMayLieTurned) {
  const Photo photo = withObject([](const Vec2& off) {
    const Vec2 p = rotation(-0.6) * off;
    return std::abs(p.x()) < 8.56 / 2 && std::abs(p.y()) < 5.398 / 2;
  });
  const Outcome<FoundObject> card = found(photo, 4, Vec2(0.5, 0.4));
  ASSERT_TRUE(card.ok());
  EXPECT_NEAR(card.value().scale, 3, 0.03);
  EXPECT_EQ(card.value().outline.size(), 4u);
}

/// Dark and light squares and bars, whose edges are clearer than a coin's.
std::array<double, 3> boldPrint(const Vec2& u) {
  const Vec2 p = u - u.array().floor().matrix();
  const bool dark = (p.x() < 0.5) != (p.y() < 0.5) || std::abs(p.x() - 0.25) < 0.06;
  return dark ? std::array<double, 3>{0.03, 0.05, 0.2} : std::array<double, 3>{0.8, 0.75, 0.7};
}

TEST(PhotoCoin, IsToldFromABoldPrint) {
  const CameraView view = closeUp();
  const MapInverse inverse(view.map());
  const Photo photo = photographed(
      480, 360,
      [&](const Vec2& u) {
        const Vec2 off = u.x() * view.w1 + u.y() * view.w2 - kMiddle;
        return off.norm() < 2.325 / 2 ? std::array<double, 3>{0.5, 0.4, 0.2} : boldPrint(u);
      },
      inverse, [](const Vec2& p) { return 1 - p.x() / 1200; }, 0.01);
  const Outcome<FoundObject> coin = found(photo, 0, Vec2(0.2, 0.1));
  ASSERT_TRUE(coin.ok());
  EXPECT_NEAR(coin.value().scale, 3, 0.03);
  EXPECT_FALSE(found(photo, 0, Vec2(-9, 4)).ok());
}

/// The coin has a light rim, which differs little from the light ground, around a darker middle.
TEST(PhotoCoin, ARimLikeTheGroundIsNotPassedOverForTheRingWithin) {
  const CameraView view = closeUp();
  const Photo photo = photographed(
      480, 360,
      [&](const Vec2& u) {
        const double off = (u.x() * view.w1 + u.y() * view.w2 - kMiddle).norm();
        if (off < 0.36 * 2.325) return std::array<double, 3>{0.4, 0.4, 0.4};
        if (off < 2.325 / 2) return std::array<double, 3>{0.74, 0.7, 0.66};
        return boldPrint(u - Vec2(0.4, 0.1));
      },
      MapInverse(view.map()), [](const Vec2&) { return 1.0; }, 0.01);
  const Outcome<FoundObject> coin = found(photo, 0, Vec2(0.1, 0.1));
  ASSERT_TRUE(coin.ok());
  EXPECT_NEAR(coin.value().scale, 3, 0.045);
}

TEST(PhotoCoin, ASoftShadowIsNoPartOfIt) {
  const CameraView view = closeUp();
  const Photo photo = photographed(
      480, 360,
      [&](const Vec2& u) {
        const double outside = (u.x() * view.w1 + u.y() * view.w2 - kMiddle).norm() - 2.325 / 2;
        if (outside < 0) return std::array<double, 3>{0.75, 0.73, 0.7};
        std::array<double, 3> ink = wavyPrint(u);
        for (double& light : ink) light *= 1 - 0.5 * std::pow(std::max(0.0, 1 - outside / 0.4), 2);
        return ink;
      },
      MapInverse(view.map()), [](const Vec2&) { return 1.0; }, 0.01);
  const Outcome<FoundObject> coin = found(photo, 0, Vec2(0.1, 0.1));
  ASSERT_TRUE(coin.ok());
  EXPECT_NEAR(coin.value().scale, 3, 0.03);
}

TEST(PhotoCoin, PlainFabricHasNone) {
  const Photo photo = photographed(
      480, 360,
      [](const Vec2&) {
        return std::array<double, 3>{0.4, 0.4, 0.4};
      },
      [](const Vec2& p) { return p; }, [](const Vec2&) { return 1.0; }, 0.005);
  const Outcome<FoundObject> coin = found(photo, 0, Vec2(0, 0));
  ASSERT_FALSE(coin.ok());
  EXPECT_NE(coin.error().message.find("No coin"), std::string::npos);
}

TEST(PhotoCoin, IsLookedForInSmallSteps) {
  const Photo photo = withObject([](const Vec2& off) { return off.norm() < 2.325 / 2; });
  const LatticeMap map = closeUp().map();
  ObjectSearch search(photo.view(), map, Mat2::Identity(), knownObjects()[0], map({0, 0}));
  int steps = 1;
  double fraction = 0;
  while (search.advance()) {
    ++steps;
    EXPECT_GE(search.fraction(), fraction);
    fraction = search.fraction();
  }
  EXPECT_GT(steps, 60);
  EXPECT_FALSE(search.advance());
}

}  // namespace
}  // namespace seamwise::testing
