// What draping costs, in factorisations of the matrix of a grid of 90 x 90 nodes with 2 unknowns
// each, by the CPU time of this thread; and a hash of the positions, which has to be the same
// wherever it is built. Drapes a sack, open below, on a lying capsule.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>

#include "drape/drape.h"
#include "mesh/mesh.h"
#include "pattern/discretise.h"

namespace seamwise {
namespace {

constexpr double kWidth = 55, kHeight = 90;  // cm

double milliseconds() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

class Capsule : public DistanceField {
 public:
  double distance(const Vec3& p, Vec3* gradient) const override {
    const Vec3 out = p - Vec3(std::clamp(p.x(), -kReach, kReach), kLevel, 0);
    const double far = length(out);
    if (gradient) *gradient = out / far;
    return far - kRadius;
  }
  static constexpr double kReach = 0.15, kLevel = 0.78, kRadius = 0.07;  // m
};

/// The quickest of several. [ms]
double gridFactorisation() {
  constexpr int kNodes = 90;
  const auto node = [](int row, int column) { return row * kNodes + column; };
  std::vector<std::pair<int, int>> pairs;
  for (int r = 0; r < kNodes; ++r)
    for (int c = 0; c < kNodes; ++c)
      for (const auto& [dr, dc] : {std::pair(0, 0), {0, 1}, {1, 0}, {1, -1}})
        if (r + dr < kNodes && c + dc >= 0 && c + dc < kNodes)
          for (int k = 0; k < 4; ++k)
            pairs.emplace_back(2 * node(r, c) + k / 2, 2 * node(r + dr, c + dc) + k % 2);
  SparseHessian matrix(2 * kNodes * kNodes, pairs);
  matrix.setZero();
  for (const auto& [i, j] : pairs) matrix.add(i, j, i == j ? 20 : -0.1);
  matrix.analyse();
  double least = 1e300;
  for (int k = 0; k < 5; ++k) {
    const double before = milliseconds();
    matrix.factorise();
    least = std::min(least, milliseconds() - before);
  }
  return least;
}

Garment sack() {
  Garment garment;
  for (const char* name : {"front", "back"}) {
    Panel panel;
    panel.name = name;
    const Polyline corners{{0, 0}, {kWidth, 0}, {kWidth, kHeight}, {0, kHeight}};
    for (std::size_t k = 0; k < 4; ++k)
      panel.edges.push_back(Curve::line(corners[k], corners[(k + 1) % 4]));
    garment.panels.push_back(panel);
  }
  garment.stitches = {{{0, 1}, {1, 3}}, {{0, 3}, {1, 1}}, {{0, 2}, {1, 2}}};
  return garment;
}

/// Round below, flat above. Without sine and cosine, which differ between libraries.
Positions wrapped(const SewnLevel& level) {
  Positions x(level.size);
  for (std::size_t p = 0; p < level.sewn.size(); ++p)
    for (std::size_t v = 0; v < level.sewn[p].size(); ++v) {
      const Vec2& at = level.pattern.pieces[p].rest[v];
      const double s = 2 * at.x() / kWidth - 1, depth = 0.17 * (1 - at.y() / kHeight) + 1e-3;
      const double across = (p == 0 ? s : -s) * 0.0095 * kWidth / 2;
      x[level.sewn[p][v]] = Vec3(across, 0.01 * at.y() - 0.02,
                                 (p == 0 ? 1 : -1) * depth * std::sqrt(std::max(0.0, 1 - s * s)));
    }
  return x;
}

/// FNV-1a over the bytes of all coordinates.
std::uint64_t hashOf(const Positions& x) {
  std::uint64_t hash = 1469598103934665603u;
  for (const Vec3& at : x)
    for (int c = 0; c < 3; ++c) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &at[c], sizeof bits);
      for (int k = 0; k < 8; ++k) hash = (hash ^ (bits >> (8 * k) & 255)) * 1099511628211u;
    }
  return hash;
}

void drapeAt(double fine, double unit) {
  Outcome<Pattern> sampled = discretise(sack(), {}, {}, 1);
  const Pattern pattern = meshed(std::move(sampled).value()).value();
  const Capsule capsule;
  double before = milliseconds();
  DrapeProblem problem;
  problem.levels = sewnLevels(pattern, 2 * fine, fine).value();
  problem.pattern = pattern, problem.shapes = restShapes(pattern);
  problem.warp.assign(2, Vec2(0, 1));
  problem.body = &capsule;
  problem.start = wrapped(problem.levels.coarse);
  Drape drape(std::move(problem));
  std::printf("edges of %.2f cm: meshes %.2f u\n", fine, (milliseconds() - before) / unit);
  while (drape.stage() != Drape::Stage::kDone) {
    const Drape::Stage stage = drape.stage();
    before = milliseconds();
    while (drape.stage() == stage) drape.advance(1e-9);
    const Drape::StageReport& r = drape.stages()[static_cast<std::size_t>(stage)];
    std::printf("  stage %d: %5d vertices, %2d steps, %6.2f u (counted %.2f), E %.5f ->",
                static_cast<int>(stage), r.vertices, r.steps, (milliseconds() - before) / unit,
                r.work, r.energies[0]);
    for (const double share : {0.25, 0.5, 0.75, 1.0})
      std::printf(" %.5f", r.energies[static_cast<std::size_t>(share * r.steps)]);
    std::printf(" J\n");
  }
  const DrapeCheck& check = drape.check();
  std::printf(
      "  tension %.2f %.2f %.2f %%, compression %.2f %.2f %.2f %%, depth %.2f mm, "
      "%d crossings, hash %016llx\n",
      100 * check.tension.median, 100 * check.tension.p99, 100 * check.tension.most,
      100 * check.compression.median, 100 * check.compression.p99, 100 * check.compression.most,
      1000 * check.depth, check.crossings,
      static_cast<unsigned long long>(hashOf(drape.positions())));
  for (const std::string& note : drape.notes()) std::printf("  %s\n", note.c_str());
}

}  // namespace
}  // namespace seamwise

int main() {
  const double unit = seamwise::gridFactorisation();
  std::printf("1 u = %.1f ms\n", unit);
  for (const double fine : {3.0, 1.5}) seamwise::drapeAt(fine, unit);
}
