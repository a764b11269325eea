#include "drape/terms.h"

#include <gtest/gtest.h>

#include "drape/drape_samples.h"

namespace seamwise {
namespace {

using testing::Chance;

/// An energy term as a function of the positions alone.
using Term = std::function<double(const Positions&, Positions*, BlockMatrix*)>;

/// A dart between two seams, randomly bent and stretched by up to `by` cm.
struct Cloth {
  explicit Cloth(double by, double edge = 6) {
    level = testing::levelOf(pattern, edge);
    mesh = testing::uncut(level, pattern);
    Chance chance;
    x = testing::laid(level, [&](int p, const Vec2& at) {
      return Vec3(0.01 * at.x() + 0.3 * p, 0.01 * at.y(), 0);
    });
    for (Vec3& at : x) at += 0.01 * by * chance.vector();
  }
  Pattern pattern = testing::plainPattern(small::skirt(), 6);
  SewnLevel level;
  SewnMesh mesh;
  Positions x;
};

BlockMatrix emptyMatrix(const Cloth& cloth) { return {cloth.mesh.size, cloth.mesh.pairs()}; }

/// Greatest difference of the gradient from finite differences, relative to the greatest gradient.
double gradientError(const Term& term, const Positions& x, double step) {
  Positions gradient(x.size(), Vec3::Zero()), at = x;
  term(x, &gradient, nullptr);
  double worst = 0, greatest = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      at[i][c] = x[i][c] + step;
      const double above = term(at, nullptr, nullptr);
      at[i][c] = x[i][c] - step;
      const double below = term(at, nullptr, nullptr);
      at[i][c] = x[i][c];
      worst = std::max(worst, std::abs((above - below) / (2 * step) - gradient[i][c]));
      greatest = std::max(greatest, std::abs(gradient[i][c]));
    }
  return worst / greatest;
}

/// Greatest relative difference of the Hessian's product with a random direction from differences
/// of the gradient.
double hessianError(const Term& term, const Cloth& cloth, double step) {
  BlockMatrix hessian = emptyMatrix(cloth);
  term(cloth.x, nullptr, &hessian);
  Chance chance;
  Positions direction, product;
  for (std::size_t i = 0; i < cloth.x.size(); ++i) direction.push_back(chance.vector());
  hessian.times(direction, product);
  Positions above(cloth.x.size(), Vec3::Zero()), below = above, at = cloth.x;
  addScaled(at, step, direction);
  term(at, &above, nullptr);
  addScaled(at, -2 * step, direction);
  term(at, &below, nullptr);
  double worst = 0, greatest = 0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Vec3 expected = (above[i] - below[i]) / (2 * step);
    worst = std::max(worst, (expected - product[i]).norm());
    greatest = std::max(greatest, product[i].norm());
  }
  return worst / greatest;
}

/// Least x H x / |x|^2 over random directions.
double leastCurvature(const Term& term, const Cloth& cloth) {
  BlockMatrix hessian = emptyMatrix(cloth);
  term(cloth.x, nullptr, &hessian);
  Chance chance;
  double least = 1e300;
  for (int k = 0; k < 200; ++k) {
    Positions direction(cloth.x.size(), Vec3::Zero()), product;
    if (k < 100) direction[k % direction.size()] = chance.vector();
    if (k >= 100)
      for (Vec3& d : direction) d = chance.vector();
    hessian.times(direction, product);
    least = std::min(least, dot(direction, product) / dot(direction, direction));
  }
  return least;
}

Term membraneOf(const Cloth& cloth, const Fabric& fabric) {
  return [&](const Positions& x, Positions* gradient, BlockMatrix* hessian) {
    return membraneEnergy(cloth.mesh, fabric, x, gradient, hessian);
  };
}
Term bendingOf(const Cloth& cloth, const Fabric& fabric) {
  return [&](const Positions& x, Positions* gradient, BlockMatrix* hessian) {
    return bendingEnergy(cloth.mesh, fabric, x, gradient, hessian);
  };
}

TEST(DrapeTerms, GradientOfEveryFabricsMembraneIsThatOfItsEnergy) {
  const Cloth cloth(1.5);
  for (const Fabric& fabric : kFabrics)
    EXPECT_LT(gradientError(membraneOf(cloth, fabric), cloth.x, 1e-7), 1e-6) << fabric.name;
}

TEST(DrapeTerms, HessianOfTheMembraneIsExactWhereThreadsAreTautAndSquare) {
  Fabric fabric = kPoplin;
  fabric.coupling = 0;
  Cloth square(0);
  square.pattern = testing::plainPattern(testing::rectangle(20, 20), 5);
  square.level = testing::levelOf(square.pattern, 5);
  square.mesh = testing::uncut(square.level, square.pattern);
  for (const double stretch : {1.02, 1.05}) {
    square.x = testing::laid(square.level, [&](int, const Vec2& at) {
      return Vec3(0.01 * stretch * at.x(), 0, 0.01 * stretch * at.y());
    });
    EXPECT_LT(hessianError(membraneOf(square, fabric), square, 1e-6), 1e-4) << stretch;
  }
}

TEST(DrapeTerms, NoHessianIsNegativeHoweverTheClothLies) {
  const Cloth cloth(3);
  for (const Fabric& fabric : kFabrics) {
    EXPECT_GE(leastCurvature(membraneOf(cloth, fabric), cloth), -1e-9) << fabric.name;
    EXPECT_GE(leastCurvature(bendingOf(cloth, fabric), cloth), -1e-9) << fabric.name;
  }
}

TEST(DrapeTerms, BendingIsQuadratic) {
  const Cloth cloth(1.5);
  EXPECT_LT(gradientError(bendingOf(cloth, kPoplin), cloth.x, 1e-4), 1e-7);
  EXPECT_LT(hessianError(bendingOf(cloth, kPoplin), cloth, 1e-3), 1e-8);
}

TEST(DrapeTerms, APressedFoldHasTheGradientOfItsEnergyAndNoNegativeHessian) {
  Cloth cloth(1.5);
  for (SewnMesh::Hinge& hinge : cloth.mesh.hinges) hinge.folded = 0.03;
  EXPECT_LT(gradientError(bendingOf(cloth, kPoplin), cloth.x, 1e-6), 1e-5);
  EXPECT_GE(leastCurvature(bendingOf(cloth, kPoplin), cloth), -1e-9);
}

TEST(DrapeTerms, RigidMotionsLeaveMembraneAndBending) {
  const Cloth cloth(1.5);
  Mat3 turn;
  turn << 0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6;
  Positions moved = cloth.x;
  for (Vec3& at : moved) at = turn * at + Vec3(0.3, -1.2, 2);
  for (const Fabric& fabric : kFabrics) {
    for (const Term& term : {membraneOf(cloth, fabric), bendingOf(cloth, fabric)}) {
      const double before = term(cloth.x, nullptr, nullptr);
      EXPECT_NEAR(term(moved, nullptr, nullptr) / before, 1, 1e-9) << fabric.name;
    }
  }
}

TEST(DrapeTerms, PiecesAsDraftedStoreNothing) {
  const Pattern pattern = testing::plainPattern(testing::rectangle(20, 30));
  const SewnLevel level = testing::levelOf(pattern, 2);
  const SewnMesh mesh = testing::uncut(level, pattern);
  const Positions x = testing::laid(level, [](int, const Vec2& at) {
    return Vec3(0.006 * at.x(), 0.01 * at.y(), 0.008 * at.x());
  });
  EXPECT_LT(membraneEnergy(mesh, kPoplin, x, nullptr, nullptr), 1e-24);
  EXPECT_LT(bendingEnergy(mesh, kPoplin, x, nullptr, nullptr), 1e-24);
}

TEST(DrapeTerms, BendingToACylinderTakesTheStiffnessOfItsDirection) {
  const Pattern pattern = testing::plainPattern(testing::rectangle(20, 30));
  const SewnLevel level = testing::levelOf(pattern, 1);
  const SewnMesh mesh = testing::uncut(level, pattern);
  constexpr double kRadius = 0.1;
  const auto energy = [&](double turn) {  // turn of the axis from the warp
    const Vec2 axis = unit(turn + kPi / 2), across = unit(turn);
    return bendingEnergy(mesh, kPoplin,
                         testing::laid(level,
                                       [&](int, const Vec2& at) {
                                         const double s = 0.01 * at.dot(across) / kRadius;
                                         return Vec3(kRadius * std::sin(s), 0.01 * at.dot(axis),
                                                     kRadius * std::cos(s));
                                       }),
                         nullptr, nullptr);
  };
  const double area = 0.2 * 0.3, squared = 1 / (kRadius * kRadius);
  const auto plate = [&](double stiffness) { return kHinge * stiffness / 2 * area * squared; };
  EXPECT_NEAR(energy(0) / plate(kPoplin.bending_weft), 1, 0.15);
  EXPECT_NEAR(energy(kPi / 2) / plate(kPoplin.bending_warp), 1, 0.15);
  EXPECT_NEAR(energy(kPi / 4) / plate((kPoplin.bending_warp + kPoplin.bending_weft) / 2), 1, 0.15);
}

TEST(DrapeTerms, AStretchedStripPullsAsItsFabric) {
  const Pattern pattern = testing::plainPattern(testing::rectangle(10, 20));
  const SewnLevel level = testing::levelOf(pattern, 2);
  const SewnMesh mesh = testing::uncut(level, pattern);
  const auto energy = [&](double weft, double warp) {
    return membraneEnergy(mesh, kPoplin,
                          testing::laid(level,
                                        [&](int, const Vec2& at) {
                                          return Vec3(0.01 * weft * at.x(), 0.01 * warp * at.y(),
                                                      0);
                                        }),
                          nullptr, nullptr) /
           0.02;  // area, m2
  };
  EXPECT_NEAR(energy(1, 1.01), 2000 * 1e-4 / 2, 1e-9);
  EXPECT_NEAR(energy(1.01, 1), 1800 * 1e-4 / 2, 1e-9);
  EXPECT_NEAR(energy(1.01, 1.01) - energy(1.01, 1) - energy(1, 1.01), 450 * 1e-4, 1e-9);
  EXPECT_NEAR(energy(1, 1.05), 2000 * (25e-4 + 3 * 4e-4) / 2, 1e-9);
}

TEST(DrapeTerms, GravityIsWeightTimesHeight) {
  const Pattern pattern = testing::plainPattern(testing::rectangle(10, 20));
  const SewnLevel level = testing::levelOf(pattern, 2);
  const SewnMesh mesh = testing::uncut(level, pattern);
  const Positions x(mesh.size, Vec3(1, 3, 2));
  Positions gradient(mesh.size, Vec3::Zero());
  EXPECT_NEAR(gravityEnergy(mesh, kPoplin, x, &gradient), 0.02 * 0.12 * 9.81 * 3, 1e-12);
  Vec3 sum = Vec3::Zero();
  for (const Vec3& g : gradient) sum += g;
  EXPECT_NEAR((sum - Vec3(0, 0.02 * 0.12 * 9.81, 0)).norm(), 0, 1e-12);
}

TEST(DrapeTerms, ContactActsOnVerticesWithinTheOffsetAndMiddlesWithinHalfOfIt) {
  const Cloth cloth(1);
  const testing::Sphere sphere(Vec3(0.05, 0.2, -0.02), 0.1);
  for (const double offset : {0.01, -0.5}) {  // -0.5: never in contact
    const BodyContact contact{&sphere, offset, 4e6};
    double expected = 0;
    const auto add = [&](const Vec3& at, double area, double reach) {
      const double depth = std::max(0.0, reach - sphere.distance(at, nullptr));
      expected += 4e6 * area * depth * depth / 2;
    };
    for (int i = 0; i < cloth.mesh.size; ++i) add(cloth.x[i], cloth.mesh.area[i], offset);
    for (const auto& t : cloth.mesh.triangles) {
      const auto& [p, q, r] = t.vertices;
      const auto near = [&](int i) { return sphere.distance(cloth.x[i], nullptr) < 0.02; };
      if (near(p) || near(q) || near(r))
        add((cloth.x[p] + cloth.x[q] + cloth.x[r]) / 3, t.area, offset / 2);
    }
    EXPECT_EQ(expected > 0, offset > 0);
    EXPECT_NEAR(contactEnergy(cloth.mesh, contact, cloth.x, nullptr, nullptr), expected,
                1e-9 * expected);
  }
}

TEST(DrapeTerms, ContactPushesByItsEnergysSlope) {
  const Cloth cloth(1);
  const testing::Sphere sphere(Vec3(0.05, 0.2, -0.02), 0.1);
  const BodyContact contact{&sphere, 0.01, 4e6};
  const Term term = [&](const Positions& x, Positions* gradient, BlockMatrix* hessian) {
    return contactEnergy(cloth.mesh, contact, x, gradient, hessian);
  };
  EXPECT_LT(gradientError(term, cloth.x, 1e-8), 1e-5);
  EXPECT_GE(leastCurvature(term, cloth), -1e-9);
}

TEST(DrapeTerms, FrictionPullsBackAlongTheBodyUpToItsLimit) {
  const Cloth cloth(1);
  std::vector<Friction> contacts;
  Chance chance;
  for (int i = 0; i < cloth.mesh.size; ++i)
    contacts.push_back({i, 0.5 + 0.1 * (i % 3), chance.vector().normalized(),
                        cloth.x[i] + (i % 2 ? 3e-4 : 3e-3) * chance.vector()});
  const Term term = [&](const Positions& x, Positions* gradient, BlockMatrix* hessian) {
    return frictionEnergy(contacts, 1e-3, x, gradient, hessian);
  };
  EXPECT_LT(gradientError(term, cloth.x, 1e-8), 1e-5);
  EXPECT_LT(hessianError(term, cloth, 1e-8), 1e-4);
  EXPECT_GE(leastCurvature(term, cloth), -1e-9);
  Positions gradient(cloth.x.size(), Vec3::Zero());
  term(cloth.x, &gradient, nullptr);
  for (const Friction& f : contacts) {
    EXPECT_NEAR(gradient[f.vertex].dot(f.normal), 0, 1e-12);
    EXPECT_LE(gradient[f.vertex].norm(), f.limit * (1 + 1e-12));
  }
}

TEST(DrapeTerms, ProximityIsThatOfTheMass) {
  const Cloth cloth(1);
  Positions from = cloth.x;
  for (Vec3& at : from) at += Vec3(0.01, 0, 0.02);
  const Term term = [&](const Positions& x, Positions* gradient, BlockMatrix* hessian) {
    return proximalEnergy(cloth.mesh, kPoplin, 0.05, from, x, gradient, hessian);
  };
  EXPECT_LT(gradientError(term, cloth.x, 1e-5), 1e-7);
  EXPECT_LT(hessianError(term, cloth, 1e-4), 1e-8);
}

TEST(DrapeTerms, TheConstantHessianIsNoLessThanThatOfTautCloth) {
  Cloth cloth(0);
  cloth.pattern = testing::plainPattern(testing::rectangle(20, 20), 5);
  cloth.level = testing::levelOf(cloth.pattern, 5);
  cloth.mesh = testing::uncut(cloth.level, cloth.pattern);
  cloth.x = testing::laid(
      cloth.level, [](int, const Vec2& at) { return Vec3(0.01 * at.x(), 0.01 * at.y(), 0); });
  Fabric fabric = kPoplin;
  fabric.shear = 0;  // the constant Hessian contains its mean over directions
  SparseHessian matrix(cloth.mesh.size, cloth.mesh.edges());
  matrix.setZero();
  addConstantHessian(cloth.mesh, fabric, matrix);
  BlockMatrix hessian = emptyMatrix(cloth);
  membraneEnergy(cloth.mesh, fabric, cloth.x, nullptr, &hessian);
  const std::vector<double> values(matrix.values(), matrix.values() + matrix.nonZeros());
  Chance chance;
  for (int k = 0; k < 20; ++k) {
    Positions direction(cloth.x.size()), product;
    for (Vec3& d : direction) d = chance.vector();
    hessian.times(direction, product);
    double bound = 0;
    for (int c = 0; c < 3; ++c) {
      VectorX one(direction.size());
      for (std::size_t i = 0; i < direction.size(); ++i) one[i] = direction[i][c];
      const VectorX image = matrix.times(values, one);
      for (int i = 0; i < image.size(); ++i) bound += one[i] * image[i];
    }
    EXPECT_LE(dot(direction, product), bound * (1 + 1e-9));
  }
}

TEST(DrapeTerms, GathersGiveWayToCompressionAlongThemOnly) {
  const Pattern pattern = testing::plainPattern(testing::rectangle(10, 10));
  const SewnLevel level = testing::levelOf(pattern, 3);
  const SewnMesh smooth = testing::uncut(level, pattern);
  SewnMesh gathered = smooth;
  for (auto& triangle : gathered.triangles) triangle.gathered_weft = true;
  const auto energyAt = [&](const SewnMesh& mesh, double across, double along = 1) {
    return membraneEnergy(mesh, kPoplin,
                          testing::laid(level,
                                        [&](int, const Vec2& at) {
                                          return Vec3(0.01 * across * at.x(), 0.01 * along * at.y(),
                                                      0);
                                        }),
                          nullptr, nullptr);
  };
  EXPECT_NEAR(energyAt(gathered, 0.8), 0.002 * energyAt(smooth, 0.8), 1e-9);
  EXPECT_NEAR(energyAt(gathered, 1.02), energyAt(smooth, 1.02), 1e-9);
  EXPECT_NEAR(energyAt(gathered, 1, 0.8), energyAt(smooth, 1, 0.8), 1e-9);
}

}  // namespace
}  // namespace seamwise
