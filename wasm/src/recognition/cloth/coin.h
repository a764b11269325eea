#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "base/outcome.h"
#include "recognition/cloth/metric.h"
#include "recognition/cloth/pixels.h"

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

/// Looks for an object's outline around a point that somebody has set in it, within a third of its
/// size from its middle: first where all of the outline parts what differs from the print from what
/// does not, then by least squares on where each bit of it does so most. Its thickness alone makes
/// an error of about 1 %. Errors: kPicture, one sentence, when nothing there has such an outline.
/// @param gram   of the map's w1, w2, in any unit of length
Outcome<FoundObject> findObject(const PixelView& pixels, const LatticeMap& map, const Mat2& gram,
                                const KnownObject& object, const Vec2& tapped);

/// The metric with that object's scale.
MetricReading scaledByObject(const MetricReading& metric, const FoundObject& object);

}  // namespace seamwise
