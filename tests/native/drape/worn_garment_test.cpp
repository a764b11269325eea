#include "drape/worn_garment.h"

#include <gtest/gtest.h>

#include "drape/mesh_places.h"
#include "support/level.h"
#include "support/meshed_samples.h"

namespace seamwise {
namespace {

/// A sample garment cut as drafted, its outlines sampled at `edge` cm.
SolvedGarment drafted(const std::string& name, double edge) {
  SolvedGarment solved{testing::readSample(name), {}, {}};
  solved.pattern = testing::meshedPattern(solved.garment, true, edge);
  solved.shapes = restShapes(solved.pattern);
  return solved;
}

std::unique_ptr<WornGarment> worn(const SolvedGarment& garment, double edge) {
  WearSettings settings;
  settings.edge = edge;
  Outcome<std::unique_ptr<WornGarment>> made = WornGarment::make(garment, settings);
  EXPECT_TRUE(made.ok()) << made.error().message;
  while (made.value()->drape().advance(1)) {
  }
  return std::move(made).value();
}

TEST(WornGarments, ATeeHangsAlikeOnAMeshTwiceAsFine) {
  SEAMWISE_THOROUGH_ONLY();
  const SolvedGarment tee = drafted("tee-m", kFineCloth / 2);
  const auto usual = worn(tee, kFineCloth), fine = worn(tee, kFineCloth / 2);
  double squares = 0;
  int count = 0;
  for (std::size_t p = 0; p < tee.pattern.pieces.size(); ++p) {
    const SewnLevel &level = usual->levels().fine, &finer = fine->levels().fine;
    const Piece& piece = finer.pattern.pieces[p];
    const MeshPlaces places(piece);
    for (std::size_t v = 0; v < level.sewn[p].size(); ++v, ++count) {
      const MeshPlace place = places.at(level.pattern.pieces[p].rest[v]);
      Vec3 apart = -usual->drape().positions()[level.sewn[p][v]];
      for (int k = 0; k < 3; ++k) {
        const int corner = piece.triangles[place.triangle][k];
        apart += place.weights[k] * fine->drape().positions()[finer.sewn[p][corner]];
      }
      squares += dot(apart, apart);
    }
  }
  EXPECT_LT(std::sqrt(squares / count), 0.0045);  // 4.4 mm: other folds at the back's sides
}

}  // namespace
}  // namespace seamwise
