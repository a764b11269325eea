#pragma once
// Small garments, sampled and meshed as for the solver.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "io/garment_json.h"
#include "mesh/mesh.h"
#include "pattern/discretise.h"
#include "support/small_garments.h"
#include "symmetry/symmetry.h"

namespace seamwise::testing {

/// A sample garment, by its file's name: "tee-m".
inline Garment readSample(const std::string& name) {
  std::ifstream file(SEAMWISE_GARMENTS "/" + name + ".json");
  std::stringstream text;
  text << file.rdbuf();
  return readGarment(text.str(), name).value().garment;
}

/// The pattern of a garment, with or without its own symmetries.
/// @param edge_length   approximate edge length of the outlines, cm
inline Pattern meshedPattern(const Garment& garment, bool symmetric, double edge_length = 1) {
  const std::vector<BodySymmetry> known = detectSymmetries(garment);
  EXPECT_FALSE(known.empty());
  Outcome<Pattern> sampled =
      discretise(garment, known, symmetric ? known : std::vector<BodySymmetry>{}, edge_length);
  EXPECT_TRUE(sampled.ok()) << sampled.error().message;
  Outcome<Pattern> mesh = meshed(std::move(sampled).value(), 6);
  EXPECT_TRUE(mesh.ok()) << mesh.error().message;
  return std::move(mesh).value();
}

/// Greatest distance of an image vertex from the position that the pattern's mirrors give. [cm]
inline double shapeAsymmetry(const Pattern& pattern, const Shapes& shapes) {
  double worst = 0;
  for (const Mirror& m : pattern.mirrors)
    for (std::size_t v = 0; v < m.image.size(); ++v)
      worst =
          std::max(worst, (shapes[m.pieces[1]][m.image[v]] - m.map(shapes[m.pieces[0]][v])).norm());
  return worst;
}

/// Least area of a triangle as a share of its rest area.
inline double leastArea(const Pattern& pattern, const Shapes& shapes) {
  double least = 1;
  for (std::size_t p = 0; p < shapes.size(); ++p) {
    for (const auto& [i, j, k] : pattern.pieces[p].triangles) {
      auto area = [i = i, j = j, k = k](const std::vector<Vec2>& x) {
        return cross(x[j] - x[i], x[k] - x[i]);
      };
      least = std::min(least, area(shapes[p]) / area(pattern.pieces[p].rest));
    }
  }
  return least;
}

/// Greatest |l_a - rho l_b| over all sewn edges. [cm]
inline double seamError(const Pattern& pattern, const Shapes& shapes) {
  double worst = 0;
  for (const Seam& s : pattern.seams) {
    auto length = [&](const SeamSide& side, std::size_t i) {
      const auto& x = shapes[side.piece];
      return (x[side.vertices[i + 1]] - x[side.vertices[i]]).norm();
    };
    for (std::size_t i = 0; i + 1 < s.a.vertices.size(); ++i)
      worst = std::max(worst, std::abs(length(s.a, i) - s.length_ratio * length(s.b, i)));
  }
  return worst;
}

}  // namespace seamwise::testing
