#pragma once
#include <cstdint>
#include <memory>

#include "recognition/base/lattice_map.h"
#include "recognition/cloth/copy_fields.h"
#include "recognition/cloth/light.h"
#include "recognition/cloth/pixels.h"
#include "recognition/cloth/registration.h"
#include "recognition/cloth/srgb.h"

namespace seamwise {

/// Finds in what the copies of a cell differ on a picture, step by step, each of some milliseconds:
/// the light, where creases have moved the cloth, and which parts to leave out.
class CopyFieldsFit {
 public:
  /// `pixels` and `curve` have to outlive it.
  /// @param nodes_across   of the field of light, along the longer side: lamps and lenses vary no
  ///   faster than ten can follow
  CopyFieldsFit(const PixelView& pixels, const LatticeMap& map, const SrgbCurve& curve,
                double nodes_across = 10);
  /// False when nothing is left to do.
  bool advance();
  double fraction() const;

  /// Once done.
  const CopyFields& fields() const { return fields_; }
  /// The picture so small that a cell has about 160 pixels a side: enough for a CellPicture.
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
  int samples_;  ///< of a cell's side
  Stage stage_ = Stage::kReduce;
  ReducedPixels reduced_;
  std::unique_ptr<ReducedPixels> fine_, coarse_;  ///< for registration and its first steps
  std::unique_ptr<LightFit> light_;
  std::unique_ptr<CopyRegistration> registration_;
  CopyFields fields_;
};

}  // namespace seamwise
