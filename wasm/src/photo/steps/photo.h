#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "photo/fabric/cell_mean.h"
#include "photo/fabric/copy_fields_fit.h"
#include "photo/fabric/metric.h"
#include "photo/lattice/lattice_search.h"
#include "photo/symmetry/group_reading.h"
#include "photo/tile/tile_reading.h"

namespace seamwise {

/// Known facts about an image besides its pixels.
struct PhotoSettings {
  /// The image is seamless: one cell of the print, or several.
  bool is_tile = false;
  /// A seamless image is read even if its edges do not meet.
  bool any_edges = false;
  /// Known lengths are those of the group's w1 and w2.
  MetricHints hints;
  std::optional<LatticeMap> lattice;
  GivenLattice use = GivenLattice::kAlign;
  /// Share of the light's unevenness that is removed.
  double flatten = 1;
};

enum class PhotoStage : std::uint8_t { kRepeat, kLight, kSymmetry, kDone };

/// Notes on a finished reading.
enum class PhotoNote : std::uint8_t {
  kUneven,              ///< creases move the print by more than on flat fabric
  kDiffers,             ///< parts of it differ from all other copies
  kAssumedFocalLength,  ///< proportions are as uncertain as a usual camera
  kUnequal,             ///< measured sides differ that the print's symmetry makes equal
};

/// Reads a print from an image, step by step: lattice, light and creases, mean of the copies,
/// group, size.
class Photo {
 public:
  /// `pixels` have to outlive the object.
  Photo(const PixelView& pixels, const PhotoSettings& settings);

  /// Runs one step of some milliseconds; returns false when done or after an error.
  bool advance();
  const std::optional<Error>& error() const { return error_; }
  PhotoStage stage() const { return stage_; }
  double fraction() const;

  // Results, valid once done:

  const LatticeReading& lattice() const { return lattice_; }
  const GroupReading& groups() const { return groups_; }
  /// Returns the map of a group's cells, with its own w1, w2 and origin.
  LatticeMap mapOf(const GroupVerdict& verdict) const;
  /// w1 and w2 of the best group in a print's orientation, exact for its lattice type. [cm], or any
  /// unit until `isScaled`.
  const std::array<Vec2, 2>& vectors() const { return vectors_; }
  bool isScaled() const { return is_scaled_; }
  /// |w2| / |w1| by the image alone, whatever was measured, and its error as a share.
  double seenAspect() const { return seen_aspect_; }
  double seenError() const { return seen_error_; }
  Confidence confidence() const;
  /// Alternative lattices.
  const std::vector<LatticeReading>& others() const { return others_; }
  const std::vector<DifferingRegion>& differing() const { return differing_; }
  const std::vector<PhotoNote>& notes() const { return notes_; }
  /// Seams of a seamless image that was read with any edges.
  const TileSeams& seams() const { return seams_; }

 private:
  void readWholeTile();
  bool search();
  bool fitFields();
  void meanCopies();
  void readSymmetry();
  void identify();
  void see();
  void place(const Mat2& measured_gram, const Vec2& along);
  const GroupVerdict& best() const { return groups_.groups[groups_.best]; }
  Outcome<MetricReading> measured(const LatticeMap& map, const MetricHints& hints) const;
  void fail(const Error& error);

  PixelView pixels_;
  PhotoSettings settings_;
  SrgbCurve curve_;
  PhotoStage stage_ = PhotoStage::kRepeat;
  std::optional<Error> error_;
  std::unique_ptr<TileReader> tile_;  ///< replaces all others for a seamless image
  std::unique_ptr<LatticeSearch> search_;
  std::unique_ptr<CopyFieldsFit> fit_;
  std::unique_ptr<CellMean> mean_;
  std::unique_ptr<GroupReader> reader_;
  LatticeReading lattice_;
  CellPicture cell_;
  GroupReading groups_;
  std::optional<Mat2> measured_gram_;  ///< basis of the lattice, once both lengths are known
  std::array<Vec2, 2> vectors_{Vec2::UnitX(), Vec2::UnitY()};
  bool is_scaled_ = false;
  double seen_aspect_ = 1, seen_error_ = 0;
  std::vector<LatticeReading> others_;
  std::vector<DifferingRegion> differing_;
  std::vector<PhotoNote> notes_;
  TileSeams seams_;
};

}  // namespace seamwise
