#pragma once
#include <cstdint>
#include <memory>

#include "photo/base/lattice_map.h"
#include "photo/fabric/copy_fields.h"
#include "photo/fabric/light.h"
#include "photo/fabric/pixels.h"
#include "photo/fabric/registration.h"
#include "photo/fabric/srgb.h"

namespace seamwise {

/// Finds the differences between the copies of a cell in an image: the light, shifts by creases,
/// and parts to omit. Each step takes some milliseconds.
class CopyFieldsFit {
 public:
  /// `pixels` and `curve` have to outlive the object.
  /// @param nodes_across   nodes of the light's field along the longer side; lamps and lenses vary
  ///                       no faster than ten can follow
  CopyFieldsFit(const PixelView& pixels, const LatticeMap& map, const SrgbCurve& curve,
                double nodes_across = 10);
  /// Runs one step; returns false when done.
  bool advance();
  double fraction() const;

  /// Valid once done.
  const CopyFields& fields() const { return fields_; }
  /// Image reduced to about 160 pixels per side of a cell, enough for a CellPicture.
  const ReducedPixels& reduced() const { return reduced_; }

 private:
  enum class Stage : std::uint8_t { kReduce, kReduceFine, kReduceCoarse, kLight, kShift, kDone };
  void beginLight();
  void beginShift();
  void finish();

  PixelView pixels_;
  LatticeMap map_;
  const SrgbCurve& curve_;
  double cell_size_, nodes_across_;
  int samples_;  ///< per side of a cell
  Stage stage_ = Stage::kReduce;
  ReducedPixels reduced_;
  std::unique_ptr<ReducedPixels> fine_, coarse_;  ///< for registration and its first steps
  std::unique_ptr<LightFit> light_;
  std::unique_ptr<CopyRegistration> registration_;
  CopyFields fields_;
};

}  // namespace seamwise
