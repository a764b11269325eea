#include "drape/newton_cg.h"

#include <gtest/gtest.h>

#include "drape/drape_samples.h"
#include "support/level.h"

namespace seamwise {
namespace {

using testing::Capsule;
using testing::Sphere;

/// Steps until three in a row move every vertex by at most 0.5 mm and hardly lower the energy.
int settle(ClothSolver& solver, int most) {
  int quiet = 0, steps = 0;
  for (; steps < most && quiet < 3; ++steps) {
    const ClothSolver::Step step = solver.newtonStep();
    quiet = step.farthest < 5e-4 && step.fall < 2e-5 * solver.weight() ? quiet + 1 : 0;
  }
  return steps;
}

/// Largest principal stretch of a triangle less 1.
double tension(const SewnMesh::Triangle& t, const Positions& x) {
  Vec3 wu = Vec3::Zero(), wv = Vec3::Zero();
  for (int k = 0; k < 3; ++k)
    wu += t.weft[k] * x[t.vertices[k]], wv += t.warp[k] * x[t.vertices[k]];
  const double a = wu.dot(wu), b = wu.dot(wv), c = wv.dot(wv);
  return std::sqrt((a + c) / 2 + std::sqrt((a - c) * (a - c) / 4 + b * b)) - 1;
}

struct Square {
  explicit Square(double edge) : level(testing::levelOf(pattern, edge)) {
    x = testing::laid(level, [](int, const Vec2& at) {
      return Vec3(0.01 * (at.x() - 20), 0.102, 0.01 * (at.y() - 20));
    });
  }
  Pattern pattern = testing::plainPattern(testing::rectangle(40, 40));
  SewnLevel level;
  SewnMesh mesh = testing::uncut(level, pattern);
  Positions x;
};

TEST(ClothSolvers, ASquareOnASphereComesToRestAndEveryStepLowersItsEnergy) {
  const Square square(testing::isThorough() ? 1.5 : 3);
  const Sphere sphere(Vec3::Zero(), 0.1);
  ClothSolver solver(square.mesh, kPoplin, sphere, square.x);
  const double start = solver.energy();
  for (int k = 0; k < 24; ++k) EXPECT_GE(solver.quasiNewtonStep().fall, 0);
  EXPECT_LT(settle(solver, 150), 150);
  EXPECT_LT(solver.energy(), start - 0.02 * solver.weight());  // falls by 2 cm and more
  double most = 0, least = 1;
  for (const auto& t : square.mesh.triangles) most = std::max(most, tension(t, solver.positions()));
  for (const Vec3& at : solver.positions()) least = std::min(least, sphere.distance(at, nullptr));
  EXPECT_LT(most, 0.03);
  EXPECT_GT(least, 0);
}

TEST(ClothSolvers, ATubeHangsOnACapsuleThatBearsItsWeight) {
  Garment garment;  // sewn at the sides and closed at the top
  garment.panels = {small::polygon("front", {{0, 0}, {30, 0}, {30, 40}, {0, 40}}),
                    small::polygon("back", {{0, 0}, {30, 0}, {30, 40}, {0, 40}})};
  small::sew(garment, "front", 1, "back", 3);
  small::sew(garment, "front", 3, "back", 1);
  small::sew(garment, "front", 2, "back", 2);
  const Pattern pattern = testing::plainPattern(garment);
  const SewnLevel level = testing::levelOf(pattern, 3);
  const SewnMesh mesh = testing::uncut(level, pattern);
  const Capsule capsule(Vec3(-0.08, 0.33, 0), Vec3(0.08, 0.33, 0), 0.03);
  ClothOptions options;
  options.friction = false;
  ClothSolver solver(
      mesh, kPoplin, capsule,
      testing::laid(level,
                    [&](int p, const Vec2& at) {
                      const double angle = (at.x() / 30 + p) * kPi, round = 0.3 / kPi;
                      const double flat = std::clamp((at.y() - 20) / 20, 0.0, 1.0);
                      return Vec3((round + (0.15 - round) * flat) * std::cos(angle), 0.01 * at.y(),
                                  -round * (1 - flat) * std::sin(angle));
                    }),
      options);
  EXPECT_LT(settle(solver, 200), 200);
  double most = 0;
  for (const auto& t : mesh.triangles) most = std::max(most, tension(t, solver.positions()));
  EXPECT_LT(most, 0.03);
  const BodyContact contact{&capsule, kPoplin.offset, options.contact_stiffness};
  Positions gradient(mesh.size, Vec3::Zero());
  contactEnergy(mesh, contact, solver.positions(), &gradient, nullptr);
  double borne = 0;
  for (const Vec3& g : gradient) borne -= g.y();
  EXPECT_NEAR(borne / solver.weight(), 1, 0.05);
}

TEST(ClothSolvers, WhatIsBoundToASideStaysThere) {
  const Square square(3);
  const Sphere sphere(Vec3::Zero(), 0.1);
  constexpr double kLeast = 0.12;  // m; it would hang at 0.1
  ClothOptions options;
  for (const Vec3& at : square.x)
    options.least_x.push_back(at.x() > 0.15 ? kLeast : at.x() < -0.15 ? -kLeast : 0);
  ClothSolver solver(square.mesh, kPoplin, sphere, square.x, options);
  settle(solver, 150);
  int bound = 0;
  for (std::size_t i = 0; i < square.x.size(); ++i) {
    const double least = options.least_x[i], x = solver.positions()[i].x();
    if (least == 0) continue;
    ++bound;
    EXPECT_GT(least > 0 ? x : -x, kLeast - 1e-3);
  }
  EXPECT_GT(bound, 10);
}

TEST(ClothSolvers, TheSameStartGivesTheSameBytes) {
  const Square square(3);
  const Sphere sphere(Vec3::Zero(), 0.1);
  const auto run = [&] {
    ClothSolver solver(square.mesh, kPoplin, sphere, square.x);
    for (int k = 0; k < 5; ++k) solver.quasiNewtonStep();
    for (int k = 0; k < 5; ++k) solver.newtonStep();
    return solver.positions();
  };
  EXPECT_EQ(run(), run());
}

}  // namespace
}  // namespace seamwise
