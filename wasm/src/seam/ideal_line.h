#pragma once
#include <vector>

#include "seam/join.h"

namespace seamwise {

/// Where the two sides of a seam should lie so that the print meets exactly: vertex positions in
/// the coordinates of their pieces. Both lie on equivalent points of the print.
struct IdealLines {
  std::vector<Vec2> a, b;
};

/// How the ideal line is found.
enum class IdealShape : std::uint8_t {
  kTransported,  ///< S2 carried over by the join, then laid rigidly on S1 (Wolff & Sorkine-Hornung
                 ///< 2019)
  kAveraged,     ///< turning angles of S1 and of the carried S2 averaged vertex by vertex, lengths
                 ///< kept, laid rigidly between the two (Wolff et al. 2019, 3.3)
};

/// The ideal lines of a seam whose sides the join carries onto each other. [cm]
/// @param at   per piece
IdealLines idealLines(const Seam& seam, const Join& join, const Shapes& shapes,
                      const std::vector<Alignment>& at, IdealShape shape);

/// The polyline with the mean of two lines' turning angles and edge lengths, vertex by vertex; in
/// an arbitrary position. Lines have equal vertex counts.
std::vector<Vec2> averagedShape(const std::vector<Vec2>& first, const std::vector<Vec2>& second);

/// `line` moved rigidly to lie as near as can be on `onto`, point by point (Procrustes).
std::vector<Vec2> laidOn(const std::vector<Vec2>& line, const std::vector<Vec2>& onto);

}  // namespace seamwise
