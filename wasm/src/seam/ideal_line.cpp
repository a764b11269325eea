#include "seam/ideal_line.h"

#include <Eigen/LU>
#include <cmath>

namespace seamwise {

std::vector<Vec2> averagedShape(const std::vector<Vec2>& first, const std::vector<Vec2>& second) {
  std::vector<Vec2> line{Vec2::Zero()};
  double heading = 0;
  for (std::size_t i = 0; i + 1 < first.size(); ++i) {
    const Vec2 a = first[i + 1] - first[i], b = second[i + 1] - second[i];
    if (i == 0) {
      heading = directionOf(a) + wrapAngle(directionOf(b) - directionOf(a)) / 2;
    } else {
      const Vec2 before_a = first[i] - first[i - 1], before_b = second[i] - second[i - 1];
      heading += (wrapAngle(directionOf(a) - directionOf(before_a)) +
                  wrapAngle(directionOf(b) - directionOf(before_b))) /
                 2;
    }
    line.push_back(line.back() + unit(heading) * ((a.norm() + b.norm()) / 2));
  }
  return line;
}

std::vector<Vec2> laidOn(const std::vector<Vec2>& line, const std::vector<Vec2>& onto) {
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();
  const double n = static_cast<double>(line.size());
  for (std::size_t i = 0; i < line.size(); ++i) from += line[i] / n, to += onto[i] / n;
  double dot = 0, turn = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    dot += (line[i] - from).dot(onto[i] - to);
    turn += cross(line[i] - from, onto[i] - to);
  }
  const Mat2 r = rotation(std::atan2(turn, dot));
  std::vector<Vec2> laid;
  laid.reserve(line.size());
  for (const Vec2& p : line) laid.push_back(to + r * (p - from));
  return laid;
}

IdealLines idealLines(const Seam& seam, const Join& join, const Shapes& shapes,
                      const std::vector<Alignment>& at, IdealShape shape) {
  const Alignment &wa = at[seam.a.piece], &wb = at[seam.b.piece];
  std::vector<Vec2> own, carried, middle;
  for (std::size_t i = 0; i < seam.a.vertices.size(); ++i) {
    own.push_back(wa.toPrint(shapes[seam.a.piece][seam.a.vertices[i]]));
    carried.push_back(join.element(wb.toPrint(shapes[seam.b.piece][seam.b.vertices[i]])));
    middle.push_back((own[i] + carried[i]) / 2);
  }
  // Transported points already carry the sign that a mirrored join gives to turning angles.
  const std::vector<Vec2> ideal = shape == IdealShape::kAveraged
                                      ? laidOn(averagedShape(own, carried), middle)
                                      : laidOn(carried, own);
  const Mat2 back = join.element.A.inverse();
  IdealLines lines;
  for (const Vec2& p : ideal) {
    lines.a.push_back(wa.toPiece(p));
    lines.b.push_back(wb.toPiece(back * (p - join.element.a)));
  }
  return lines;
}

}  // namespace seamwise
