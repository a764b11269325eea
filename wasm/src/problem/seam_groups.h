#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "pattern/garment.h"

namespace seamwise {

/// Place of a seam on the body. Values are part of the result file: append only.
enum class SeamPlace : std::uint8_t {
  kOther,
  kCentreFront,
  kCentreBack,
  kSide,
  kShoulder,
  kPrincess,
  kYoke,
  kWaist,
  kSleeveHeadFront,
  kSleeveHeadBack,
  kSleeve,
  kInseam,
  kOutseam,
  kCrotch,
  kBand,
  kCuff,
  kCollar,
  kHood,
  kPocket,
  kDart,
  kFacing,
  kInside
};

/// Name of a place in files: "centre front".
const char* placeName(SeamPlace place);

/// End of a seam as it is worn; left and right are the wearer's.
enum class SeamEnd : std::uint8_t { kTop, kBottom, kLeft, kRight };

/// Side of the body, the wearer's.
enum class BodySide : std::uint8_t { kMiddle, kLeft, kRight };

/// Consecutive stitches that a sewist calls one seam.
struct SeamGroup {
  std::vector<int> seams;  ///< stitch numbers, along the outline of the first side's piece
  SeamPlace place = SeamPlace::kOther;
  double visibility = 0;  ///< ShapingTuning::kVisible or more: seen at once
  std::array<SeamEnd, 2> ends = {SeamEnd::kTop, SeamEnd::kBottom};  ///< before the first, after the
                                                                    ///< last stitch
  BodySide side = BodySide::kMiddle;
};

/// Groups the stitches of a garment and finds their places on the body: from the placement of the
/// pieces in the file, else from the arrangement that its seams and symmetries imply. Names of
/// pieces only decide what geometry leaves open. Every stitch belongs to one group; groups are in
/// the order of their first stitches.
/// @param known   the garment's symmetries
std::vector<SeamGroup> seamGroups(const Garment& garment, const std::vector<BodySymmetry>& known);

/// Sets the visibility of every stitch, and its weight unless the file states one other than 1. A
/// gathered seam has little weight, because it cannot match. Matched lines weigh as much as a side
/// seam.
void weighByVisibility(const std::vector<SeamGroup>& groups, Garment* garment,
                       std::vector<MatchLine>* matches);

}  // namespace seamwise
