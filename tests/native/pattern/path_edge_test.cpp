#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "io/garment_document.h"
#include "pattern/discretise.h"
#include "support/garment_texts.h"
#include "support/paths.h"
#include "support/small_garments.h"
#include "symmetry/symmetry.h"

namespace seamwise {
namespace {

using testing::asPath;
using testing::expectRefused;
using testing::mustRead;
using testing::panelOf;
using testing::polyline;
using testing::twoRectangles;

Json withPath(const Json& params, const char* coords = "relative") {
  Json garment = twoRectangles();
  garment["properties"]["curvature_coords"] = coords;
  panelOf(garment, "front")["edges"][1]["curvature"] = {{"type", "path"}, {"params", params}};
  return garment;
}

Json cubics(int count) {
  Json params = Json::array();
  for (int k = 0; k < count; ++k) {
    const auto at = [&](double part) { return Json{(k + part) / count, 0}; };
    params.push_back(k + 1 < count ? Json{at(0.3), at(0.7), at(1)} : Json{at(0.3), at(0.7)});
  }
  return params;
}

std::vector<Vec2> frontSide(const Json& garment) {
  return mustRead(garment).garment.panels[0].edges[1].points();
}

TEST(PathEdge, IsReadInEitherKindOfCoordinates) {
  // front side from (10, 0) to (10, 20)
  const std::vector<Vec2> points{{10, 0}, {8, 2}, {8, 8}, {10, 10}, {8, 12}, {8, 18}, {10, 20}};
  EXPECT_EQ(frontSide(withPath({{{8, 2}, {8, 8}, {10, 10}}, {{8, 12}, {8, 18}}}, "absolute")),
            points);
  const std::vector<Vec2> relative =
      frontSide(withPath({{{0.1, 0.1}, {0.4, 0.1}, {0.5, 0}}, {{0.6, 0.1}, {0.9, 0.1}}}));
  ASSERT_EQ(relative.size(), points.size());
  for (std::size_t k = 0; k < points.size(); ++k)
    EXPECT_NEAR((relative[k] - points[k]).norm(), 0, 1e-12);
}

TEST(PathEdge, OfOneCubicIsACubic) {
  EXPECT_EQ(frontSide(withPath({{{0.25, 0.1}, {0.75, 0.1}}})),
            (std::vector<Vec2>{{10, 0}, {8, 5}, {8, 15}, {10, 20}}));
}

TEST(PathEdge, StandsInADocumentWithAllItsPointsFaceUp) {
  Json garment = withPath({{{8, 2}, {8, 8}, {9, 10}}, {{8, 12}, {8, 18}}}, "absolute");
  Json& front = panelOf(garment, "front");
  front["vertices"].insert(front["vertices"].end(), {{2, 2}, {6, 2}, {4, 9}});
  front["holes"] = Json::parse(R"([[{"endpoints": [4, 5]}, {"endpoints": [5, 6], "curvature":
      {"type": "path", "params": [[[6, 4], [5, 5], [5, 6]], [[5, 7], [5, 8]]]}}, {"endpoints": [6, 4]}]])");
  const auto document = garmentDocument(garment.dump(), "shirt.json");
  ASSERT_TRUE(document.ok());
  const Json piece = Json::parse(document.value())["pieces"][0];
  EXPECT_EQ(piece["outline"][1]["points"],
            Json::parse("[[10,0],[8,2],[8,8],[9,10],[8,12],[8,18],[10,20]]"));
  const Json hole = piece["holes"][0];  // clockwise
  EXPECT_EQ(hole[1]["points"], Json::parse("[[4,9],[5,8],[5,7],[5,6],[5,5],[6,4],[6,2]]"));
}

TEST(PathEdge, ThatIsMalformedIsNamedWithItsPanel) {
  const auto refused = [](const Json& params, std::initializer_list<const char*> words) {
    expectRefused(withPath(params), Failure::kCurvature, words);
  };
  const char* write = "malformed path; write its cubics as [[c1, c2, point], ..., [c1, c2]]";
  refused(Json::array(), {"panel 'front', edge 1", write});
  refused({{{0.1, 0}, {0.2, 0}}, {{0.3, 0}, {0.4, 0}}}, {"edge 1", write});
  refused({{{0.1, 0}, {0.2, 0}, {0.5, 0}}, {{0.3, 0}}}, {write});
  refused({{{0.1, 0}, {0.2, 0}, {0.5, 0}}, {{0.3, 0}, {0.4, 0}, {1, 0}}}, {write});
  refused({5, {{0.3, 0}, {0.4, 0}}}, {write});
  refused({{{0.1, 0}, {0.2, "x"}, {0.5, 0}}, {{0.3, 0}, {0.4, 0}}}, {"edge 1", "control point"});
  refused({{{0.1, 0}, {0.2, 1e5}, {0.5, 0}}, {{0.3, 0}, {0.4, 0}}}, {"edge 1", "100 m"});
}

TEST(PathEdge, OfTooManyCubicsIsNamedWithItsPanel) {
  EXPECT_EQ(frontSide(withPath(cubics(2000))).size(), 6001u);
  expectRefused(withPath(cubics(2001)), Failure::kTooLarge,
                {"panel 'front', edge 1", "2001 cubics", "at most 2000"});
  Json garment = withPath(cubics(2000));
  Json& front = panelOf(garment, "front");
  const Json path = front["edges"][1]["curvature"];
  for (Json& edge : front["edges"]) edge["curvature"] = path;
  mustRead(garment);
  front["vertices"] = Json::parse("[[0,0],[5,0],[10,0],[10,10],[10,20],[0,20]]");
  front["edges"] = Json::array();
  for (int k = 0; k < 6; ++k)
    front["edges"].push_back({{"endpoints", {k, (k + 1) % 6}}, {"curvature", path}});
  expectRefused(garment, Failure::kTooLarge, {"panel 'front'", "10000 cubics"});
}

/// Relative positions along a seam's side of the vertices at corners of the outline.
std::vector<double> sharpShares(const Pattern& pattern, const SeamSide& side) {
  const std::vector<Vec2>& rest = pattern.pieces[side.piece].rest;
  std::vector<double> shares, along{0};
  for (std::size_t k = 1; k < side.vertices.size(); ++k)
    along.push_back(along.back() + (rest[side.vertices[k]] - rest[side.vertices[k - 1]]).norm());
  for (std::size_t k = 1; k + 1 < side.vertices.size(); ++k)
    if (std::abs(turnAt(rest[side.vertices[k - 1]], rest[side.vertices[k]],
                        rest[side.vertices[k + 1]])) > 0.3)
      shares.push_back(along[k] / along.back());
  return shares;
}

/// A square with a roof as one path, sewn along the roof to a strip.
Garment roofed(const Vec2& ridge) {
  Garment g;
  Panel house = small::polygon("house", {{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  house.edges[2] = polyline({{10, 10}, ridge, {0, 10}});
  const double length = house.edges[2].length();
  g.panels = {house, small::polygon("strip", {{0, 0}, {length, 0}, {length, 3}, {0, 3}})};
  small::sew(g, "house", 2, "strip", 0);
  return g;
}

TEST(PathEdge, HasAVertexAtItsCornerAndAtThatShareOfTheOtherSide) {
  const Garment g = roofed({7.3, 14.2});
  const auto pattern = discretise(g, {}, {}, 1);
  ASSERT_TRUE(pattern.ok());
  const Piece& house = pattern.value().pieces[0];
  const auto at = std::find_if(house.rest.begin(), house.rest.end(),
                               [](const Vec2& p) { return (p - Vec2(7.3, 14.2)).norm() < 1e-9; });
  ASSERT_NE(at, house.rest.end());
  const Seam& seam = pattern.value().seams[0];
  const auto& a = seam.a.vertices;
  const auto k =
      std::find(a.begin(), a.end(), static_cast<int>(at - house.rest.begin())) - a.begin();
  const Vec2& partner =
      pattern.value().pieces[1].rest[seam.b.vertices[static_cast<std::size_t>(k)]];
  const double first = Vec2(2.7, 4.2).norm();
  EXPECT_NEAR(partner.x(), g.panels[1].edges[0].length() - first, 1e-6);
  EXPECT_NEAR(seam.length_ratio, 1, 1e-9);
}

TEST(PathEdge, SewsCornersOfBothSidesToEachOtherThoughTheirSharesDifferALittle) {
  Garment g = roofed({7, 14});
  Panel other = small::polygon("other", {{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  other.edges[2] = polyline({{10, 10}, {3.1, 14.05}, {0, 10}});
  g.panels[1] = other;
  g.stitches[0].b.edge = 2;
  const auto pattern = discretise(g, {}, {}, 1);
  ASSERT_TRUE(pattern.ok());
  const Seam& seam = pattern.value().seams[0];
  const auto a = sharpShares(pattern.value(), seam.a), b = sharpShares(pattern.value(), seam.b);
  ASSERT_EQ(a.size(), 1u);
  ASSERT_EQ(b.size(), 1u);
  for (std::size_t k = 1; k < seam.a.vertices.size(); ++k)
    EXPECT_GT((pattern.value().pieces[0].rest[seam.a.vertices[k]] -
               pattern.value().pieces[0].rest[seam.a.vertices[k - 1]])
                  .norm(),
              0.4);
}

/// Redraws every edge as a path of so many cubics.
Garment redrawn(Garment g, int parts) {
  for (Panel& panel : g.panels)
    for (Curve& edge : panel.edges) edge = asPath(edge, parts);
  return g;
}

TEST(PathEdge, IsSampledAsTheCurveThatItRedraws) {
  for (const Garment& g : {small::tee(2), small::tee(0)}) {
    const auto plain = discretise(g, {}, {}, 1), drawn = discretise(redrawn(g, 37), {}, {}, 1);
    ASSERT_TRUE(plain.ok() && drawn.ok());
    for (std::size_t p = 0; p < g.panels.size(); ++p) {
      const auto &one = plain.value().pieces[p].rest, &other = drawn.value().pieces[p].rest;
      ASSERT_EQ(one.size(), other.size());
      for (std::size_t v = 0; v < one.size(); ++v) EXPECT_NEAR((one[v] - other[v]).norm(), 0, 1e-8);
    }
  }
}

TEST(PathEdge, MirrorsLikeTheCurveThatItRedraws) {
  const Garment g = small::tee(2);
  const auto plain = detectSymmetries(g), drawn = detectSymmetries(redrawn(g, 11));
  ASSERT_EQ(plain.size(), drawn.size());
  for (std::size_t k = 0; k < plain.size(); ++k) {
    EXPECT_EQ(plain[k].pieces[0], drawn[k].pieces[0]);
    EXPECT_EQ(plain[k].pieces[1], drawn[k].pieces[1]);
    EXPECT_LT(drawn[k].residual, 1e-6);
    EXPECT_NEAR((plain[k].map.shift - drawn[k].map.shift).norm(), 0, 1e-6);
  }
}

TEST(PathEdge, ThatIsAHalfOutlineMirrorsWithItsCorners) {
  // Only two edges, each with two interior corners; the axis runs through their ends.
  Panel panel;
  panel.name = "bodice";
  panel.edges = {polyline({{0, 0}, {20, 0}, {20, 30}, {12, 45}, {0, 44}}),
                 polyline({{0, 44}, {-12, 45}, {-20, 30}, {-20, 0}, {0, 0}})};
  Garment g;
  g.panels = {panel};
  const auto found = detectSymmetries(g);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LT(found[0].residual, 1e-6);
  const auto pattern = discretise(g, found, found, 1);
  ASSERT_TRUE(pattern.ok());
  const Piece& piece = pattern.value().pieces[0];
  for (const Vec2& corner : {Vec2(20, 0), Vec2(20, 30), Vec2(-12, 45), Vec2(-20, 0)})
    EXPECT_TRUE(std::any_of(piece.rest.begin(), piece.rest.end(),
                            [&](const Vec2& p) { return (p - corner).norm() < 1e-9; }));
}

TEST(PathEdge, WhoseMirrorImageHasABulgeIsNone) {
  Panel panel = small::polygon("front", {{-20, 0}, {20, 0}, {20, 60}, {-20, 60}});
  panel.edges[1] = polyline({{20, 0}, {20, 21}, {19, 22}, {19, 23}, {20, 24}, {20, 60}});
  panel.edges[3] = polyline({{-20, 60}, {-20, 0}});
  Garment g;
  g.panels = {panel};
  EXPECT_TRUE(detectSymmetries(g).empty());
}

}  // namespace
}  // namespace seamwise
