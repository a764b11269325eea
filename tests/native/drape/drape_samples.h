#pragma once
// Small fabrics and bodies whose rest state can be calculated by hand.
#include <gtest/gtest.h>

#include <functional>

#include "drape/distance.h"
#include "drape/sewn_mesh.h"
#include "drape/vectors.h"
#include "support/meshed_samples.h"

namespace seamwise::testing {

class Sphere : public DistanceField {
 public:
  Sphere(const Vec3& centre, double radius) : centre_(centre), radius_(radius) {}
  double distance(const Vec3& p, Vec3* gradient) const override {
    const Vec3 out = p - centre_;
    const double far = length(out);
    if (gradient) *gradient = out / far;
    return far - radius_;
  }

 private:
  Vec3 centre_;
  double radius_;
};

/// All points within `radius` of the segment from `a` to `b`.
class Capsule : public DistanceField {
 public:
  Capsule(const Vec3& a, const Vec3& b, double radius) : a_(a), b_(b), radius_(radius) {}
  double distance(const Vec3& p, Vec3* gradient) const override {
    const Vec3 axis = b_ - a_;
    const double t = std::clamp(dot(p - a_, axis) / dot(axis, axis), 0.0, 1.0);
    const Vec3 out = p - a_ - t * axis;
    const double far = length(out);
    if (gradient) *gradient = out / far;
    return far - radius_;
  }

 private:
  Vec3 a_, b_;
  double radius_;
};

/// Pattern of a garment's pieces on outlines sampled at `edge` cm, without a solve's interior
/// vertices.
inline Pattern plainPattern(const Garment& garment, double edge = 1) {
  Outcome<Pattern> sampled = discretise(garment, {}, {}, edge);
  EXPECT_TRUE(sampled.ok()) << sampled.error().message;
  Outcome<Pattern> mesh = meshed(std::move(sampled).value(), 6);
  EXPECT_TRUE(mesh.ok()) << mesh.error().message;
  return std::move(mesh).value();
}

/// A rectangle from (0, 0) to (width, height) cm.
inline Garment rectangle(double width, double height) {
  Garment garment;
  garment.panels = {small::polygon("cloth", {{0, 0}, {width, 0}, {width, height}, {0, height}})};
  return garment;
}

/// Warp along y in every piece.
inline std::vector<Vec2> upright(const Pattern& pattern) {
  return std::vector<Vec2>(pattern.pieces.size(), Vec2(0, 1));
}

inline SewnLevel levelOf(const Pattern& pattern, double edge) {
  Outcome<SewnLevel> level = sewnLevel(pattern, edge);
  EXPECT_TRUE(level.ok()) << level.error().message;
  return std::move(level).value();
}

inline SewnMesh uncut(const SewnLevel& level, const Pattern& pattern) {
  return sewnMesh(level, shapesOf(level, pattern, restShapes(pattern)), upright(pattern));
}

/// Positions of the sewn vertices under a map of the pieces' points; where several pieces meet, the
/// last one's.
/// @param map   (piece, point in cm) -> m
inline Positions laid(const SewnLevel& level, const std::function<Vec3(int, const Vec2&)>& map) {
  Positions x(level.size, Vec3::Zero());
  for (std::size_t p = 0; p < level.sewn.size(); ++p)
    for (std::size_t v = 0; v < level.sewn[p].size(); ++v)
      x[level.sewn[p][v]] = map(static_cast<int>(p), level.pattern.pieces[p].rest[v]);
  return x;
}

/// Pseudorandom numbers in [-1, 1), equal on all platforms.
class Chance {
 public:
  double next() {
    state_ = state_ * 1664525u + 1013904223u;
    return state_ / 2147483648.0 - 1;
  }
  Vec3 vector() {
    const double x = next(), y = next(), z = next();
    return {x, y, z};
  }

 private:
  std::uint32_t state_ = 7;
};

}  // namespace seamwise::testing
