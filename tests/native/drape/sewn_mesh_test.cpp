#include "drape/sewn_mesh.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "drape/drape_samples.h"

namespace seamwise {
namespace {

double longestEdge(const Pattern& pattern) {
  double longest = 0;
  for (const Piece& piece : pattern.pieces)
    for (const auto& t : piece.triangles)
      for (int k = 0; k < 3; ++k)
        longest = std::max(longest, (piece.rest[t[k]] - piece.rest[t[(k + 1) % 3]]).norm());
  return longest;
}

int vertexAt(const Pattern& pattern, int piece, const Vec2& at) {
  const auto& rest = pattern.pieces[piece].rest;
  for (std::size_t v = 0; v < rest.size(); ++v)
    if ((rest[v] - at).norm() < 1e-9) return static_cast<int>(v);
  ADD_FAILURE() << "no vertex at " << at.transpose();
  return 0;
}

/// Edges of the fabric with their numbers of triangles.
std::map<std::pair<int, int>, int> edgesOf(const SewnMesh& mesh) {
  std::map<std::pair<int, int>, int> edges;
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) ++edges[std::minmax({t.vertices[k], t.vertices[(k + 1) % 3]})];
  return edges;
}

TEST(SewnMeshes, BothLevelsHaveEdgesOfTheirSizeAndTheAreaOfThePieces) {
  const Pattern pattern = testing::meshedPattern(small::tee(1.5), true);
  const auto levels = sewnLevels(pattern);
  ASSERT_TRUE(levels.ok()) << levels.error().message;
  double area = 0;
  for (const Piece& piece : pattern.pieces)
    for (const auto& t : piece.triangles) area += triangleArea(piece.rest, t);
  for (const auto& [level, edge] : {std::pair(&levels.value().coarse, kCoarseCloth),
                                    std::pair(&levels.value().fine, kFineCloth)}) {
    EXPECT_LT(longestEdge(level->pattern), 2 * edge);
    const SewnMesh mesh = testing::uncut(*level, pattern);
    double of_triangles = 0, of_vertices = 0;
    for (const auto& t : mesh.triangles) of_triangles += t.area;
    for (const double a : mesh.area) of_vertices += a;
    EXPECT_NEAR(of_triangles, of_vertices, 1e-12);
    EXPECT_NEAR(of_triangles * 1e4 / area, 1, 0.01);
  }
  EXPECT_GT(levels.value().fine.size, 3 * levels.value().coarse.size);
}

TEST(SewnMeshes, BothSidesOfEverySeamAreOneVertex) {
  const Pattern pattern = testing::meshedPattern(small::tee(1.5), true);
  const SewnLevel level = testing::levelOf(pattern, 1.5);
  std::set<int> numbers;
  for (const auto& sewn : level.sewn) numbers.insert(sewn.begin(), sewn.end());
  EXPECT_EQ(static_cast<int>(numbers.size()), level.size);
  EXPECT_EQ(*numbers.rbegin(), level.size - 1);
  for (const Seam& seam : level.pattern.seams)
    for (std::size_t k = 0; k < seam.a.vertices.size(); ++k)
      EXPECT_EQ(level.sewn[seam.a.piece][seam.a.vertices[k]],
                level.sewn[seam.b.piece][seam.b.vertices[k]]);
}

TEST(SewnMeshes, SeamsBendLikeClothAndFreeEdgesDoNot) {
  const Pattern pattern = testing::meshedPattern(small::tee(1.5), true);
  const SewnLevel level = testing::levelOf(pattern, 3);
  const SewnMesh mesh = testing::uncut(level, pattern);
  std::set<std::pair<int, int>> hinges;
  for (const auto& h : mesh.hinges) hinges.insert(std::minmax({h.vertices[0], h.vertices[1]}));
  EXPECT_EQ(hinges.size(), mesh.hinges.size());
  for (const auto& [edge, count] : edgesOf(mesh)) EXPECT_EQ(hinges.count(edge), count == 2);
  const Seam& side = level.pattern.seams[0];
  for (std::size_t k = 0; k + 1 < side.a.vertices.size(); ++k)
    EXPECT_TRUE(hinges.count(std::minmax({level.sewn[side.a.piece][side.a.vertices[k]],
                                          level.sewn[side.a.piece][side.a.vertices[k + 1]]})));
}

TEST(SewnMeshes, ADartClosesAndItsTipStays) {
  Garment garment;
  garment.panels = {
      small::polygon("front", {{0, 0}, {20, 0}, {20, 30}, {12, 30}, {10, 15}, {8, 30}, {0, 30}})};
  small::sew(garment, "front", 3, "front", 4);
  const Pattern pattern = testing::plainPattern(garment);
  const SewnLevel level = testing::levelOf(pattern, 1.5);
  const auto sewn = [&](double x, double y) {
    return level.sewn[0][vertexAt(level.pattern, 0, {x, y})];
  };
  EXPECT_EQ(sewn(12, 30), sewn(8, 30));
  EXPECT_NE(sewn(10, 15), sewn(8, 30));
  const SewnMesh mesh = testing::uncut(level, pattern);
  EXPECT_EQ(mesh.triangles.size(), level.pattern.pieces[0].triangles.size());
  for (const auto& [edge, count] : edgesOf(mesh)) EXPECT_LE(count, 2);
}

TEST(SewnMeshes, ThreePiecesThatMeetInACornerShareIt) {
  Garment garment;  // two sewn side by side, a third across both
  garment.panels = {small::polygon("left", {{0, 0}, {10, 0}, {10, 10}, {0, 10}}),
                    small::polygon("right", {{0, 0}, {10, 0}, {10, 10}, {0, 10}}),
                    small::polygon("top", {{0, 0}, {10, 0}, {20, 0}, {20, 8}, {0, 8}})};
  small::sew(garment, "left", 1, "right", 3);
  small::sew(garment, "left", 2, "top", 0);
  small::sew(garment, "right", 2, "top", 1);
  const Pattern pattern = testing::plainPattern(garment);
  const SewnLevel level = testing::levelOf(pattern, 1.5);
  const int corner = level.sewn[2][vertexAt(level.pattern, 2, {10, 0})];
  EXPECT_EQ(level.sewn[0][vertexAt(level.pattern, 0, {10, 10})], corner);
  EXPECT_EQ(level.sewn[1][vertexAt(level.pattern, 1, {0, 10})], corner);
}

TEST(SewnMeshes, SeamsInTheSameDirectionJoinStartToStart) {
  Garment garment;
  garment.panels = {small::polygon("a", {{0, 0}, {10, 0}, {10, 10}, {0, 10}}),
                    small::polygon("b", {{0, 0}, {10, 0}, {10, 10}, {0, 10}})};
  garment.stitches.push_back({{0, 1}, {1, 1}, true});
  const Pattern pattern = testing::plainPattern(garment);
  const SewnLevel level = testing::levelOf(pattern, 1.5);
  for (const double y : {0.0, 10.0})
    EXPECT_EQ(level.sewn[0][vertexAt(level.pattern, 0, {10, y})],
              level.sewn[1][vertexAt(level.pattern, 1, {10, y})]);
}

TEST(SewnMeshes, ALinearShapeIsFollowedExactly) {
  const Pattern pattern = testing::meshedPattern(small::tee(1.5), false);
  const auto linear = [](const Vec2& p) {
    return Vec2(1.1 * p.x() - 0.2 * p.y() + 3, 0.1 * p.x() + 0.9 * p.y() - 5);
  };
  Shapes shapes = restShapes(pattern);
  for (auto& points : shapes)
    for (Vec2& p : points) p = linear(p);
  for (const double edge : {3.0, 1.5}) {
    const SewnLevel level = testing::levelOf(pattern, edge);
    const Shapes cut = shapesOf(level, pattern, shapes);
    for (std::size_t p = 0; p < cut.size(); ++p)
      for (std::size_t v = 0; v < cut[p].size(); ++v)
        EXPECT_LT((cut[p][v] - linear(level.pattern.pieces[p].rest[v])).norm(), 1e-9);
  }
}

TEST(SewnMeshes, VerticesKeptFromTheResultAreWhereItPutsThem) {
  const Pattern pattern = testing::meshedPattern(small::tee(1.5), false);
  Shapes shapes = restShapes(pattern);
  testing::Chance chance;
  for (auto& points : shapes)
    for (Vec2& p : points) p += Vec2(0.3 * chance.next(), 0.3 * chance.next());
  const SewnLevel level = testing::levelOf(pattern, 1.5);
  const Shapes cut = shapesOf(level, pattern, shapes);
  for (std::size_t p = 0; p < cut.size(); ++p)
    for (const int v : level.pattern.pieces[p].outline) {
      double least = 1e300;
      for (const Vec2& at : shapes[p]) least = std::min(least, (at - cut[p][v]).norm());
      EXPECT_EQ(least, 0);
    }
}

TEST(SewnMeshes, ALinearFieldIsProlongedExactly) {
  Garment garment;  // two pieces of one sheet
  garment.panels = {small::polygon("left", {{0, 0}, {14, 0}, {11, 20}, {0, 25}}),
                    small::polygon("right", {{14, 0}, {30, 0}, {30, 20}, {11, 20}})};
  small::sew(garment, "left", 1, "right", 3);
  const Pattern pattern = testing::plainPattern(garment);
  const auto levels = sewnLevels(pattern);
  ASSERT_TRUE(levels.ok());
  const auto linear = [](int, const Vec2& p) {
    return Vec3(0.01 * p.x() + 0.002 * p.y(), 0.3 - 0.01 * p.y(), 0.005 * p.x() + 1);
  };
  const Positions fine = prolonged(levels.value(), testing::laid(levels.value().coarse, linear));
  const Positions expected = testing::laid(levels.value().fine, linear);
  for (std::size_t i = 0; i < fine.size(); ++i) EXPECT_LT((fine[i] - expected[i]).norm(), 1e-12);
}

TEST(SewnMeshes, TheGrainTurnsWithThePiece) {
  const Pattern pattern = testing::plainPattern(testing::rectangle(20, 10));
  const SewnLevel level = testing::levelOf(pattern, 3);
  const Shapes shapes = shapesOf(level, pattern, restShapes(pattern));
  const SewnMesh along_x = sewnMesh(level, shapes, {Vec2(1, 0)});
  const SewnMesh along_y = sewnMesh(level, shapes, {Vec2(0, 1)});
  for (std::size_t t = 0; t < along_x.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(along_x.triangles[t].warp[k], along_y.triangles[t].weft[k], 1e-9);
      EXPECT_NEAR(along_x.triangles[t].weft[k], -along_y.triangles[t].warp[k], 1e-9);
    }
  for (std::size_t h = 0; h < along_x.hinges.size(); ++h)
    EXPECT_NEAR(along_x.hinges[h].warp, 1 - along_y.hinges[h].warp, 1e-12);
}

}  // namespace
}  // namespace seamwise
