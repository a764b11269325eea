#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace seamwise {

/// Reason for the failure of a stage. The values are part of the JavaScript API: append only.
enum class Failure : std::uint8_t {
  kNone = 0,
  kCancelled = 1,
  kInternal = 2,
  // garment file
  kNotJson = 10,
  kTooLarge = 11,
  kNotAGarment = 12,
  kNoPanels = 13,
  kUnits = 14,
  kNumber = 15,
  kEdgeIndex = 16,
  kEdgeZeroLength = 17,
  kCurvature = 18,
  kOutlineOpen = 19,
  kOutlineSelfIntersects = 20,
  kSeamUnknownPiece = 21,
  kSeamUnknownEdge = 22,
  kSeamEdgeTwice = 23,
  kSeamMalformed = 24,
  kMesh = 25,
  // print file
  kNotAPrint = 40,
  kGroupUnknown = 41,
  kLattice = 42,
  // symmetries
  kSymmetryMalformed = 60,
  kSymmetryUnknownPiece = 61,
  kSymmetryDoesNotMirror = 62,
  kSymmetryGroup = 63,
  kSymmetryConflict = 64,
  // options
  kOptions = 80,
  // photos of fabric
  kPicture = 90,
};

/// A failure with its message, one sentence that names the piece or seam and the remedy.
struct Error {
  Failure code = Failure::kNone;
  std::string message;
  int piece = -1;  ///< index in the garment, -1: none
  int seam = -1;   ///< stitch number in the garment file, -1: none
  /// Code of the note (pattern/note.h) with the reason why a symmetry cannot hold, or empty.
  const char* reason = "";
};

/// A value, or the error that prevented it. A std::variant would add at least 0.5 kB to a module,
/// compressed.
template <class T>
class Outcome {
 public:
  Outcome(T value) : value_(std::move(value)) {}      // NOLINT(google-explicit-constructor)
  Outcome(Error error) : error_(std::move(error)) {}  // NOLINT(google-explicit-constructor)
  bool ok() const { return value_.has_value(); }
  const T& value() const& { return *value_; }
  T& value() & { return *value_; }
  T&& value() && { return *std::move(value_); }
  const Error& error() const { return error_; }

 private:
  std::optional<T> value_;
  Error error_;
};

}  // namespace seamwise
