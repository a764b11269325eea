#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "base/outcome.h"
#include "recognition/cloth/print_difference.h"

namespace seamwise {

/// A thing of known size that lies flat on the cloth. [cm]
struct KnownObject {
  std::string_view name;  ///< as options have it
  double width = 0, height = 0;
  bool round = false;
};

/// "eur1", "eur2", "quarter", "gbp1" by their mints, "card" (ISO/IEC 7810 ID-1), and "a4" (ISO
/// 216).
std::span<const KnownObject> knownObjects();

/// Where a known object lies.
struct FoundObject {
  std::vector<Vec2> outline;  ///< on the whole picture. [px]
  double scale = 0;           ///< cm for a unit of length of the gram it was found with
  double error = 0;           ///< standard error of that, as a share
};

/// How an outline lies on the cloth, in the gram's unit of length, w1 along x.
struct ObjectPlacing {
  Vec2 center = Vec2::Zero();
  double size = 1, turn = 0;
};

/// How many bits of an outline are looked at, and how many sizes of it at most.
constexpr int kOutlineBits = 48, kMostSizes = 128;

/// A bit of an outline whose longer half side is 1: place, and unit normal outwards.
struct OutlineBit {
  Vec2 at = Vec2::Zero(), normal = Vec2::UnitX();
};

/// Looks for an object's outline around a point that somebody has set in it, within a third of its
/// size from its middle, step by step: first where all of the outline parts what differs from the
/// print from what does not, one size after the other, then by least squares on where each bit of
/// it does so most. What has such an edge along less than a third is refused: parts of a rim that
/// look like the cloth beside it leave its size open. Its thickness alone makes an error of about
/// 1 %.
class ObjectSearch {
 public:
  /// `pixels` have to outlive it.
  /// @param gram   of the map's w1, w2, in any unit of length
  ObjectSearch(const PixelView& pixels, const LatticeMap& map, const Mat2& gram,
               const KnownObject& object, const Vec2& tapped);

  /// One step of some milliseconds; false when nothing is left to do, or once it has failed.
  bool advance();
  double fraction() const;
  /// kPicture, one sentence, when nothing there has such an outline.
  const std::optional<Error>& error() const { return error_; }
  /// Once done.
  const FoundObject& found() const { return found_; }

 private:
  enum class Stage : std::uint8_t { kCompare, kSizes, kRefine, kDone };
  /// Between what is surely print and what is not, or where the difference itself is steepest.
  enum class Edge : std::uint8_t { kCovered, kSteepest };
  void trySize();
  bool chooseSize();
  void refine(double window, Edge of);
  void finish();
  float clearness(const ObjectPlacing& placing, float least) const;
  float edge(const Vec2& inside, const Vec2& outside, Edge of) const;
  Vec2 pictureOf(const Vec2& cloth) const { return map_(to_lattice_ * cloth); }
  Vec2 onPicture(const Vec2& bit) const;
  double pixel() const;

  PrintDifference difference_;
  LatticeMap map_;
  KnownObject object_;
  std::array<OutlineBit, kOutlineBits> bits_;
  Mat2 to_lattice_, to_cloth_;
  Vec2 tapped_;      ///< on the cloth
  double most_ = 0;  ///< size that is tried
  Stage stage_ = Stage::kCompare;
  double size_ = 0;  ///< the next one
  float best_;       ///< clearness of all sizes so far
  std::array<std::pair<float, ObjectPlacing>, kMostSizes> sizes_;
  int count_ = 0;  ///< of them
  ObjectPlacing placing_;
  int supports_ = 0;  ///< bits of the outline that have an edge close to it
  double left_ = 0;   ///< root mean square of what least squares leave, over the size
  std::optional<Error> error_;
  FoundObject found_;
};

}  // namespace seamwise
