#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "base/outcome.h"
#include "photo/fabric/print_difference.h"

namespace seamwise {

/// Flat object of known size on the fabric. [cm]
struct KnownObject {
  std::string_view name;  ///< name in options
  double width = 0, height = 0;
  bool round = false;
};

/// Returns the known objects: "eur1", "eur2", "quarter" and "gbp1" with the sizes of their mints,
/// "card" (ISO/IEC 7810 ID-1), and "a4" (ISO 216).
std::span<const KnownObject> knownObjects();

/// Position of a known object.
struct FoundObject {
  std::vector<Vec2> outline;  ///< points of the whole image. [px]
  double scale = 0;           ///< cm per unit of length of the gram in the search
  double error = 0;           ///< standard error of the scale, as a share
};

/// Placement of an outline on the fabric, in the gram's unit of length, w1 along x.
struct ObjectPlacing {
  Vec2 center = Vec2::Zero();
  double size = 1, turn = 0;
};

/// Number of outline bits, and maximum number of sizes.
constexpr int kOutlineBits = 48, kMostSizes = 128;

/// Bit of an outline whose longer half side is 1: position and outward unit normal.
struct OutlineBit {
  Vec2 at = Vec2::Zero(), normal = Vec2::UnitX();
};

/// Finds an object's outline around a point that the user sets in it, within about a third of half
/// its size from its middle.
/// First, the search tries one size after another and looks for outlines that separate print from
/// other content all around. The other content includes a contact shadow, which ends softly. So
/// the search then looks for the largest outline within that has a sharp edge, and least squares
/// fit it to the sharpest edge near each of its bits. An outline with such an edge along less than
/// a third of it is rejected, because parts of a rim that look like the adjacent fabric leave the
/// size open. The thickness of the object alone causes an error of about 1 %.
class ObjectSearch {
 public:
  /// `pixels` have to outlive the object.
  /// @param gram   Gram matrix of the map's w1, w2, in any unit of length
  /// @param tapped   the user's point on the whole image. [px]
  ObjectSearch(const PixelView& pixels, const LatticeMap& map, const Mat2& gram,
               const KnownObject& object, const Vec2& tapped);

  /// Runs one step of some milliseconds; returns false when done or after an error.
  bool advance();
  double fraction() const;
  /// kPicture with one sentence if no such outline is found there.
  const std::optional<Error>& error() const { return error_; }
  /// Valid once done.
  const FoundObject& found() const { return found_; }

 private:
  enum class Stage : std::uint8_t { kCompare, kSizes, kRims, kRefine, kDone };
  void trySize();
  bool chooseSize();
  void tryRim();
  bool chooseRim();
  bool isInShadow(const ObjectPlacing& rim) const;
  void refine(double window);
  void finish();
  float clearness(const ObjectPlacing& placing, float least) const;
  float sharpness(const ObjectPlacing& placing, float least) const;
  Vec2 pictureOf(const Vec2& fabric) const { return map_(to_lattice_ * fabric); }
  Vec2 onPicture(const Vec2& bit) const;
  double pixel() const;

  PrintDifference difference_;
  LatticeMap map_;
  KnownObject object_;
  std::array<OutlineBit, kOutlineBits> bits_;
  Mat2 to_lattice_, to_fabric_;
  Vec2 tapped_;      ///< the user's point on the fabric
  double most_ = 0;  ///< largest size to try
  Stage stage_ = Stage::kCompare;
  double size_ = 0;  ///< next size to try
  float best_;       ///< greatest clearness so far
  std::array<std::pair<float, ObjectPlacing>, kMostSizes> sizes_;
  std::array<bool, kMostSizes> is_rim_{};
  int count_ = 0;        ///< number of tried sizes
  ObjectPlacing whole_;  ///< outline with a shadow
  ObjectPlacing placing_;
  int supports_ = 0;  ///< number of outline bits with an edge nearby
  double left_ = 0;   ///< root mean square residual of the least squares, relative to the size
  std::optional<Error> error_;
  FoundObject found_;
};

}  // namespace seamwise
