// Time of draping a solved garment, in factorisations of a grid in the same process.
#include <cstdint>
#include <cstring>

#include "bench.h"
#include "drape/worn_garment.h"

namespace seamwise::bench {
namespace {

SolvedGarment solvedWith(const Json& task, double print_scale) {
  Solver solver = required(Solver::make(problemOf(task, print_scale)));
  Result result = required(solver.finish());
  return {std::move(result.garment), std::move(result.pattern), std::move(result.shapes)};
}

/// FNV-1a hash over the bytes of all coordinates; equal drapes have equal hashes on all platforms.
std::string hashOf(const Positions& x) {
  std::uint64_t hash = 1469598103934665603u;
  for (const Vec3& at : x)
    for (int c = 0; c < 3; ++c) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &at[c], sizeof bits);
      for (int k = 0; k < 8; ++k) hash = (hash ^ (bits >> (8 * k) & 255)) * 1099511628211u;
    }
  return std::to_string(hash);
}

struct Draped {
  double first = 0, whole = 0, counted = 0;  ///< ms, ms, units
  std::unique_ptr<WornGarment> worn;
};

/// Drapes to the end. `first` is the time of the first stage, whose shape is shown before the end.
Draped drape(SolvedGarment garment, const WearSettings& settings) {
  Draped draped;
  const Watch watch;
  draped.worn = required(WornGarment::make(std::move(garment), settings));
  Drape& cloth = draped.worn->drape();
  const Drape::Stage begin = cloth.stage();
  while (cloth.advance(0.1))
    if (cloth.stage() == begin) draped.first = watch.milliseconds();
  draped.whole = watch.milliseconds();
  draped.counted = cloth.work();
  return draped;
}

}  // namespace

Json drapeTask(const Json& task) {
  const double unit = gridFactorisation();
  const Draped cold = drape(solvedWith(task, 1), {});
  WearSettings again;
  const Drape& cloth = cold.worn->drape();
  for (const Vec3& at : cloth.positions())
    for (int c = 0; c < 3; ++c) again.settled.push_back(at[c] / kCentimetre);
  const Draped warm = drape(solvedWith(task, 1.3), again);
  std::size_t triangles = 0;
  for (const Piece& piece : cold.worn->levels().fine.pattern.pieces)
    triangles += piece.triangles.size();
  const DrapeCheck& check = cloth.check();
  return {
      {"triangles", triangles},
      {"unit", unit},
      {"first", cold.first / unit},
      {"settled", cold.whole / unit},
      {"counted", cold.counted},
      {"again", warm.whole / unit},
      {"milliseconds", {{"first", cold.first}, {"settled", cold.whole}, {"again", warm.whole}}},
      {"tension",
       {{"median", check.tension.median}, {"p99", check.tension.p99}, {"max", check.tension.most}}},
      {"crossings", check.crossings},
      {"depth", check.depth / kCentimetre},
      {"hash", hashOf(cloth.positions())}};
}

}  // namespace seamwise::bench
