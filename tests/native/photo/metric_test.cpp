#include "photo/fabric/metric.h"

#include <gtest/gtest.h>

#include <cmath>

#include "photo/photo_samples.h"

namespace seamwise::testing {
namespace {

CameraView slanted() {
  CameraView view;
  view.width = 3600;
  view.height = 2700;
  view.f = 2600;  // 26 mm on 35 mm film
  view.tilt = 0.3;
  view.turn = 0.4;
  return view;
}

MetricReading metricOf(const CameraView& view, const MetricHints& hints) {
  LatticeReading reading;
  reading.map = view.map();
  reading.uncertainty = 1e-4;
  return readMetric(reading, view.width, view.height, hints).value();
}

double aspect(const Mat2& gram) { return std::sqrt(gram(1, 1) / gram(0, 0)); }
double cosine(const Mat2& gram) { return gram(0, 1) / std::sqrt(gram(0, 0) * gram(1, 1)); }

TEST(PhotoMetric, AFocalLengthTellsTheCellsShape) {
  MetricHints hints;
  hints.f35 = 26;
  const MetricReading metric = metricOf(slanted(), hints);
  EXPECT_EQ(metric.source, MetricSource::kFocalLength);
  EXPECT_FALSE(metric.scaled);
  EXPECT_NEAR(aspect(metric.gram), std::sqrt(0.85), 1e-9);
  EXPECT_NEAR(cosine(metric.gram), 2 / std::sqrt(85), 1e-9);
  EXPECT_NEAR(metric.gram(0, 0) * metric.gram(1, 1) - metric.gram(0, 1) * metric.gram(0, 1), 1,
              1e-9);
}

TEST(PhotoMetric, WithoutOneItsErrorIsTold) {
  CameraView view = slanted();
  view.f = 3000;  // instead of 2700
  const MetricReading metric = metricOf(view, {});
  EXPECT_EQ(metric.source, MetricSource::kAssumedFocalLength);
  const double off = std::abs(std::log(aspect(metric.gram) / std::sqrt(0.85)));
  EXPECT_GT(off, 1e-4);
  EXPECT_LT(off, metric.aspect_error);
  MetricHints hints;
  hints.f35 = 30;
  EXPECT_LT(metricOf(view, hints).aspect_error, metric.aspect_error / 3);
}

TEST(PhotoMetric, AScanNeedsNone) {
  CameraView view = slanted();
  view.tilt = 0;
  const MetricReading metric = metricOf(view, {});
  EXPECT_EQ(metric.source, MetricSource::kScan);
  EXPECT_NEAR(aspect(metric.gram), std::sqrt(0.85), 1e-9);
  EXPECT_LT(metric.aspect_error, 0.001);
}

TEST(PhotoMetric, OneLengthTellsTheScale) {
  MetricHints hints;
  hints.f35 = 26;
  hints.lengths[1] = std::sqrt(85.0);
  const MetricReading metric = metricOf(slanted(), hints);
  EXPECT_TRUE(metric.scaled);
  EXPECT_EQ(metric.along, Vec2::UnitY());
  EXPECT_NEAR(metric.gram(0, 0), 100, 1e-6);
  EXPECT_NEAR(metric.gram(0, 1), 20, 1e-6);
}

TEST(PhotoMetric, TwoLengthsTellTheShapeWithoutFocalLength) {
  CameraView view = slanted();
  view.f = 3400;
  MetricHints hints;
  hints.lengths = {10, std::sqrt(85.0)};
  const MetricReading metric = metricOf(view, hints);
  EXPECT_EQ(metric.source, MetricSource::kTwoLengths);
  EXPECT_EQ(metric.along, Vec2::Zero());
  EXPECT_NEAR(metric.gram(0, 0), 100, 1e-9);
  EXPECT_NEAR(metric.gram(1, 1), 85, 1e-9);
  EXPECT_NEAR(std::acos(cosine(metric.gram)), std::acos(2 / std::sqrt(85)), 0.3 * kPi / 180);
}

TEST(PhotoMetric, TwoPointsTellTheScaleUnderTilt) {
  const LatticeMap map = slanted().map();
  MetricHints hints;
  hints.f35 = 26;
  // Span from -w1 + w2 / 2 to w1 / 2 + w2.
  hints.span = {map(Vec2(-1, 0.5)), map(Vec2(0.5, 1)), Vec2(16, 4.5).norm()};
  const MetricReading metric = metricOf(slanted(), hints);
  EXPECT_NEAR(metric.gram(0, 0), 100, 1e-6);
  EXPECT_LT((metric.along - Vec2(1.5, 0.5)).norm(), 1e-6);
  EXPECT_GT(metric.length_error, 0);
  EXPECT_LT(metric.length_error, 0.01);
}

TEST(PhotoMetric, AnotherBasisHasAnotherGram) {
  MetricReading metric;
  metric.gram << 4, 0, 0, 9;
  Mat2 m;
  m << 1, 1, -1, 1;
  EXPECT_EQ(metric.rebased(m), (Mat2() << 13, -5, -5, 13).finished());
}

TEST(PhotoMetric, WhatCannotBeIsRefused) {
  MetricHints hints;
  hints.lengths[0] = -3;
  EXPECT_NE(readMetric({}, 10, 10, hints).error().message.find("longer than 0 cm"),
            std::string::npos);
  hints = {};
  hints.f35 = 0;
  EXPECT_FALSE(readMetric({}, 10, 10, hints).ok());
  hints = {};
  hints.span = {Vec2(5, 5), Vec2(6, 6), 3};
  EXPECT_FALSE(readMetric({}, 10, 10, hints).ok());
}

TEST(PhotoMetric, ThePicturesEdgeNearestTheLatticeIsTheWarp) {
  CameraView view;
  view.w1 = Vec2(10, 0);
  view.w2 = Vec2(0, 8);
  view.turn = -0.2;
  Mat2 gram;
  gram << 100, 0, 0, 64;
  const auto [w1, w2] = placedLattice(view.map(), gram);
  EXPECT_LT((w1 - Vec2(10, 0)).norm(), 1e-9);
  EXPECT_LT((w2 - Vec2(0, 8)).norm(), 1e-9);
  view.turn = 2;  // now w2 is nearest to the left
  const auto [left1, left2] = placedLattice(view.map(), gram);
  EXPECT_LT((left1 - Vec2(0, 10)).norm(), 1e-9);
  EXPECT_LT((left2 - Vec2(-8, 0)).norm(), 1e-9);
}

TEST(PhotoMetric, AnObliqueLatticeIsTurnedToItsNearestDirection) {
  CameraView view;
  view.w1 = Vec2(10, 0);
  view.w2 = Vec2(5, 8.66);
  view.turn = 0.1;
  Mat2 gram;
  gram << 100, 50, 50, 99.9956;
  const auto [w1, w2] = placedLattice(view.map(), gram);
  EXPECT_LT((w1 - Vec2(10, 0)).norm(), 1e-9);
  EXPECT_LT((w2 - Vec2(5, 8.66)).norm(), 1e-9);
}

}  // namespace
}  // namespace seamwise::testing
