#pragma once
#include <vector>

#include "seam/join.h"

namespace seamwise {

/// Positions of a seam's sides at which the print matches exactly: vertices in the coordinates of
/// their pieces. Both sides are at equivalent points of the print.
struct IdealLines {
  std::vector<Vec2> a, b;
};

/// The construction of the ideal line from the sides S1 and S2.
enum class IdealShape : std::uint8_t {
  kTransported,  ///< S2 carried over by the join, then fitted rigidly to S1 (Wolff &
                 ///< Sorkine-Hornung 2019)
  kAveraged,     ///< turning angles and edge lengths of S1 and of the carried S2 averaged vertex by
                 ///< vertex, then fitted rigidly between the two (Wolff et al. 2019, 3.3)
};

/// The ideal lines of a seam whose sides the join carries onto each other. [cm]
/// @param at   alignment per piece
IdealLines idealLines(const Seam& seam, const Join& join, const Shapes& shapes,
                      const std::vector<Alignment>& at, IdealShape shape);

/// The polyline with the mean of two lines' turning angles and edge lengths, vertex by vertex, at
/// an arbitrary position. Both lines have the same number of vertices.
std::vector<Vec2> averagedShape(const std::vector<Vec2>& first, const std::vector<Vec2>& second);

/// Moves `line` rigidly for the least-squares distance of corresponding points to `onto`
/// (Procrustes).
std::vector<Vec2> laidOn(const std::vector<Vec2>& line, const std::vector<Vec2>& onto);

}  // namespace seamwise
