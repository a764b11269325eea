#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "recognition/cloth/cell_mean.h"
#include "recognition/cloth/copy_fields_fit.h"
#include "recognition/cloth/metric.h"
#include "recognition/lattice/lattice_search.h"
#include "recognition/symmetry/group_reading.h"
#include "recognition/tile/tile_reading.h"

namespace seamwise {

/// What somebody knows of a picture beside its pixels.
struct PhotoSettings {
  /// The picture is seamless: one cell of the print, or several.
  bool is_tile = false;
  /// A seamless picture is read whether its edges meet or not.
  bool any_edges = false;
  /// Lengths are those of the group's w1 and w2.
  MetricHints hints;
  std::optional<LatticeMap> lattice;
  GivenLattice use = GivenLattice::kAlign;
  /// Share of the light's unevenness that is taken away.
  double flatten = 1;
};

enum class PhotoStage : std::uint8_t { kRepeat, kLight, kSymmetry, kDone };

/// What may be said of a picture beside what was read.
enum class PhotoNote : std::uint8_t {
  kUneven,              ///< creases move the print by more than lies flat
  kDiffers,             ///< parts of it differ from all other copies
  kAssumedFocalLength,  ///< proportions are known no better than a usual camera's
  kUnequal,             ///< sides that the print's symmetry has equal measure differently
};

/// A print read off a picture, step by step: lattice, light and creases, the mean of the copies,
/// its group, its size.
class Photo {
 public:
  /// `pixels` have to outlive it.
  Photo(const PixelView& pixels, const PhotoSettings& settings);

  /// One step of some milliseconds; false when nothing is left to do, or once it has failed.
  bool advance();
  const std::optional<Error>& error() const { return error_; }
  PhotoStage stage() const { return stage_; }
  double fraction() const;

  // Once done:

  const LatticeReading& lattice() const { return lattice_; }
  const GroupReading& groups() const { return groups_; }
  /// Where the cells of a group lie, with its own w1, w2 and origin.
  LatticeMap mapOf(const GroupVerdict& verdict) const;
  /// w1 and w2 of the best group as prints have them: as exact as its lattice is. [cm], or of any
  /// unit until `isScaled`.
  const std::array<Vec2, 2>& vectors() const { return vectors_; }
  bool isScaled() const { return is_scaled_; }
  /// |w2| / |w1| as the picture alone shows it, whatever was measured, and the share by which it
  /// may err.
  double seenAspect() const { return seen_aspect_; }
  double seenError() const { return seen_error_; }
  Confidence confidence() const;
  /// Other lattices that it may be.
  const std::vector<LatticeReading>& others() const { return others_; }
  const std::vector<DifferingRegion>& differing() const { return differing_; }
  const std::vector<PhotoNote>& notes() const { return notes_; }
  /// Of a seamless picture that was read with any edges.
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
  std::unique_ptr<TileReader> tile_;  ///< of a seamless picture, in place of all others
  std::unique_ptr<LatticeSearch> search_;
  std::unique_ptr<CopyFieldsFit> fit_;
  std::unique_ptr<CellMean> mean_;
  std::unique_ptr<GroupReader> reader_;
  LatticeReading lattice_;
  CellPicture cell_;
  GroupReading groups_;
  std::optional<Mat2> measured_gram_;  ///< of the lattice's basis, once lengths of both are known
  std::array<Vec2, 2> vectors_{Vec2::UnitX(), Vec2::UnitY()};
  bool is_scaled_ = false;
  double seen_aspect_ = 1, seen_error_ = 0;
  std::vector<LatticeReading> others_;
  std::vector<DifferingRegion> differing_;
  std::vector<PhotoNote> notes_;
  TileSeams seams_;
};

}  // namespace seamwise
