#include "drape/wrap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "drape/weld.h"
#include "support/level.h"
#include "support/meshed_samples.h"

namespace seamwise {
namespace {

struct Sample {
  Garment garment;
  Pattern pattern;
};

Sample sampleOf(const std::string& name) {
  Sample sample{testing::readSample(name), {}};
  const std::vector<BodySymmetry> known = detectSymmetries(sample.garment);
  // 3 cm: the resolution that a drape starts with.
  Outcome<Pattern> sampled = discretise(sample.garment, known, known, 3);
  EXPECT_TRUE(sampled.ok()) << name;
  sample.pattern = meshed(std::move(sampled).value(), 3).value();
  return sample;
}

const Form& form() {
  static const Form kForm = Form::make(*measuresOf("m")).value();
  return kForm;
}

PiecePositions wrap(const Sample& sample) {
  Outcome<PiecePositions> positions = wrapped(sample.garment, sample.pattern, form());
  EXPECT_TRUE(positions.ok()) << positions.error().message;
  return std::move(positions).value();
}

// Lengths of the triangles' edges as shares of their lengths in the piece; sorted.
std::vector<double> stretches(const Pattern& pattern, const PiecePositions& positions) {
  std::vector<double> out;
  for (std::size_t p = 0; p < positions.size(); ++p)
    for (const std::array<int, 3>& triangle : pattern.pieces[p].triangles)
      for (int e = 0; e < 3; ++e) {
        const int u = triangle[e], v = triangle[(e + 1) % 3];
        out.push_back((positions[p][u] - positions[p][v]).norm() /
                      (pattern.pieces[p].rest[u] - pattern.pieces[p].rest[v]).norm());
      }
  std::sort(out.begin(), out.end());
  return out;
}

class DrapeSamples : public ::testing::TestWithParam<const char*> {};

TEST_P(DrapeSamples, AreWrappedOutsideTheFormSewnAndHardlyStretched) {
  const Sample sample = sampleOf(std::string(GetParam()) + "-m");
  const PiecePositions positions = wrap(sample);
  const Hanging hanging = hang(sample.garment, sample.pattern, form()).value();
  ASSERT_EQ(hanging.parts.size(), sample.pattern.pieces.size());
  for (std::size_t p = 0; p < positions.size(); ++p)
    for (const Vec3& x : positions[p]) {
      ASSERT_TRUE(x.allFinite());
      EXPECT_GT(form().distance(x, only(hanging.parts[p]) | kTorsoAndNeck, nullptr), 0.85);
    }
  for (const Seam& seam : sample.pattern.seams)
    for (std::size_t i = 0; i < seam.a.vertices.size(); ++i)
      EXPECT_EQ(positions[seam.a.piece][seam.a.vertices[i]],
                positions[seam.b.piece][seam.b.vertices[i]]);
  const std::vector<double> all = stretches(sample.pattern, positions);
  EXPECT_NEAR(all[all.size() / 2], 1, 0.03);
  EXPECT_LT(all[all.size() * 99 / 100], 2);
  EXPECT_LT(all.back(), 4);
}

INSTANTIATE_TEST_SUITE_P(All, DrapeSamples,
                         ::testing::ValuesIn(testing::sampleOf<const char*>(
                             4, {"asymmetric-dress", "raglan", "shirt", "trousers", "apron",
                                 "gathered-skirt", "hoodie", "patchwork-jacket", "princess-dress",
                                 "shift-dress", "six-gore-skirt", "tee"})));

TEST(DrapeWrap, LaysTheHemOfABackThatHangsLowerThanItsFrontsAsLongAsItIs) {
  const Sample sample = sampleOf("shirt-m");
  const PiecePositions positions = wrap(sample);
  int count = 0;
  for (std::size_t p = 0; p < positions.size(); ++p) {
    const Piece& piece = sample.pattern.pieces[p];
    if (piece.name.find("front") != 0 && piece.name != "back") continue;
    double bottom = 1e9;
    for (const Vec2& x : piece.rest) bottom = std::min(bottom, x.y());
    for (std::size_t i = 0; i < piece.outline.size(); ++i) {
      const int u = piece.outline[i], v = piece.outline[(i + 1) % piece.outline.size()];
      const Vec2 edge = piece.rest[v] - piece.rest[u];
      if (std::max(piece.rest[u].y(), piece.rest[v].y()) > bottom + 3) continue;
      if (std::abs(edge.x()) < std::abs(edge.y())) continue;
      const double ratio = (positions[p][v] - positions[p][u]).norm() / edge.norm();
      EXPECT_GT(ratio, 0.7) << piece.name << " at " << piece.rest[u].transpose();
      EXPECT_LT(ratio, 1.3) << piece.name << " at " << piece.rest[u].transpose();
      ++count;
    }
  }
  EXPECT_GT(count, 20);
}

TEST(DrapeParts, AreFoundByPlacement) {
  const auto partsOf = [](const char* name) {
    const Sample sample = sampleOf(name);
    return hang(sample.garment, sample.pattern, form()).value().parts;
  };
  using P = BodyPart;
  EXPECT_EQ(partsOf("tee-m"), (std::vector<P>{P::kTorso, P::kTorso, P::kLeftArm, P::kRightArm}));
  EXPECT_EQ(partsOf("trousers-m"), (std::vector<P>{P::kLeftLeg, P::kRightLeg, P::kRightLeg,
                                                   P::kLeftLeg, P::kTorso, P::kTorso}));
  EXPECT_EQ(partsOf("six-gore-skirt-m"), std::vector<P>(8, P::kTorso));
  EXPECT_EQ(partsOf("shirt-m"),
            (std::vector<P>{P::kTorso, P::kTorso, P::kTorso, P::kTorso, P::kNeck, P::kNeck,
                            P::kLeftArm, P::kRightArm, P::kLeftArm, P::kRightArm}));
  EXPECT_EQ(partsOf("hoodie-m"), (std::vector<P>{P::kTorso, P::kTorso, P::kLeftArm, P::kRightArm,
                                                 P::kLeftArm, P::kRightArm, P::kHead, P::kHead,
                                                 P::kHead, P::kTorso, P::kTorso, P::kTorso}));
}

TEST(DrapeWrap, KeepsSymmetricGarmentsExactlySymmetric) {
  for (const char* name : {"tee-m", "princess-dress-m", "trousers-m"}) {
    const Sample sample = sampleOf(name);
    const PiecePositions positions = wrap(sample);
    for (const Mirror& mirror : sample.pattern.mirrors)
      for (std::size_t v = 0; v < mirror.image.size(); ++v)
        EXPECT_EQ(positions[mirror.pieces[1]][mirror.image[v]],
                  mirrored(positions[mirror.pieces[0]][v]));
  }
}

TEST(DrapeWrap, ClosesARingAtTheWidthOfItsPieces) {
  const Sample sample = sampleOf("tee-m");
  const PiecePositions positions = wrap(sample);
  // Length around the hem, vertex by vertex.
  double around = 0, width = 0;
  for (const int p : {0, 1}) {
    const Piece& piece = sample.pattern.pieces[p];
    double lowest = 1e9;
    for (const Vec2& q : piece.rest) lowest = std::min(lowest, q.y());
    const std::size_t n = piece.outline.size();
    for (std::size_t i = 0; i < n; ++i) {
      const int u = piece.outline[i], v = piece.outline[(i + 1) % n];
      if (piece.rest[u].y() > lowest + 1 || piece.rest[v].y() > lowest + 1) continue;
      around += (positions[p][u] - positions[p][v]).norm();
      width += (piece.rest[u] - piece.rest[v]).norm();
    }
  }
  EXPECT_GT(width, 100);
  EXPECT_NEAR(around, width, 0.04 * width);
}

// The same garment with its pieces in the opposite order and other names.
Sample reversed(Sample sample) {
  const int last = static_cast<int>(sample.garment.panels.size()) - 1;
  std::reverse(sample.garment.panels.begin(), sample.garment.panels.end());
  std::reverse(sample.pattern.pieces.begin(), sample.pattern.pieces.end());
  for (Panel& panel : sample.garment.panels) panel.name = "x" + panel.name;
  for (Piece& piece : sample.pattern.pieces) piece.name = "x" + piece.name;
  for (Seam& seam : sample.pattern.seams) {
    seam.a.piece = last - seam.a.piece;
    seam.b.piece = last - seam.b.piece;
  }
  for (Mirror& mirror : sample.pattern.mirrors)
    for (int& piece : mirror.pieces) piece = last - piece;
  for (MatchLine& match : sample.garment.matches) {
    match.piece_a = last - match.piece_a;
    match.piece_b = last - match.piece_b;
  }
  return sample;
}

TEST(DrapeWrap, GivesTheSameBytesWhateverTheOrderAndTheNamesOfPieces) {
  for (const char* name : {"tee-m", "trousers-m", "shirt-m"}) {
    const Sample sample = sampleOf(name);
    PiecePositions other = wrap(reversed(sample));
    std::reverse(other.begin(), other.end());
    EXPECT_TRUE(wrap(sample) == other) << name;
  }
}

TEST(DrapeWrap, LiftsGarmentsThatHangAboutTheOriginOntoTheFloor) {
  Sample sample = sampleOf("tee-m");
  const PiecePositions there = wrap(sample);
  for (Panel& panel : sample.garment.panels) panel.placement_shift.y() -= 112.07;
  const PiecePositions lifted = wrap(sample);
  for (std::size_t p = 0; p < there.size(); ++p)
    for (std::size_t v = 0; v < there[p].size(); ++v)
      EXPECT_LT((there[p][v] - lifted[p][v]).norm(), 1e-6);
}

TEST(DrapeWrap, SaysWhatIsWrongWithPlacements) {
  const Sample sample = sampleOf("tee-m");
  const auto messageOf = [&](const auto& change) {
    Sample bad = sample;
    for (Panel& panel : bad.garment.panels) change(&panel);
    const Outcome<PiecePositions> positions = wrapped(bad.garment, bad.pattern, form());
    return positions.ok() ? std::string() : positions.error().message;
  };
  EXPECT_EQ(messageOf([](Panel* panel) {
              panel->placement_shift.x() = std::numeric_limits<double>::quiet_NaN();
            }),
            "Piece 'front' is placed at something that is no number.");
  EXPECT_EQ(messageOf([](Panel* panel) { panel->placement_shift *= 1e4; }),
            "Piece 'front' is placed far from any body: give 'translation' in the units of the "
            "garment's file, from the floor up, and align it again.");
}

TEST(DrapeWrap, LaysOneFrontOverTheOther) {
  const Sample sample = sampleOf("shirt-m");
  const PiecePositions positions = wrap(sample);
  // Overlap at half height: the wearer's right front is further out.
  const auto outermost = [&](int piece) {
    double z = -1e9;
    for (const Vec3& x : positions[piece])
      if (std::abs(x.x()) < 3 && std::abs(x.y() - 105) < 6) z = std::max(z, x.z());
    return z;
  };
  EXPECT_GT(outermost(1), outermost(0) + 0.2);
}

TEST(DrapeWrap, HangsStrapsFromTheNeckWithoutAFold) {
  for (const char* size : {"s", "m"}) {
    const Sample sample = sampleOf(std::string("apron-") + size);
    const PiecePositions positions = wrap(sample);
    std::size_t strap = 0;
    while (sample.pattern.pieces[strap].name != "neck_strap") ++strap;
    const std::vector<Vec3>& x = positions[strap];
    const auto& triangles = sample.pattern.pieces[strap].triangles;
    const auto face = [&](const std::array<int, 3>& t) {
      const Vec3 n = crossProduct(x[t[1]] - x[t[0]], x[t[2]] - x[t[0]]);
      return Vec3(n / length(n));
    };
    const auto common = [](const std::array<int, 3>& a, const std::array<int, 3>& b) {
      return std::count_if(a.begin(), a.end(),
                           [&](int v) { return std::find(b.begin(), b.end(), v) != b.end(); });
    };
    for (const auto& a : triangles)
      for (const auto& b : triangles)
        if (common(a, b) == 2) {
          EXPECT_GT(dot(face(a), face(b)), 0.3) << size;
        }
  }
}

}  // namespace
}  // namespace seamwise
