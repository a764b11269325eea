#include "photo/fabric/tile_symmetry.h"

#include "photo/base/repeating_place.h"

namespace seamwise {

TileSymmetry::TileSymmetry(std::array<std::vector<float>, 3> planes, int columns, int rows,
                           const GroupData& group)
    : planes_(std::move(planes)), columns_(columns), rows_(rows), elements_(cosets(group)) {
  for (std::vector<float>& plane : symmetric_)
    plane.assign(static_cast<std::size_t>(columns) * rows, 0);
}

bool TileSymmetry::advance(int samples) {
  for (; row_ < rows_ && samples > 0; ++row_) {
    for (const LatticeElement& element : elements_) add(element, row_);
    samples -= columns_ * static_cast<int>(elements_.size());
  }
  return row_ < rows_;
}

void TileSymmetry::add(const LatticeElement& element, int row) {
  const float share = 1 / static_cast<float>(elements_.size());
  const double v = (row + 0.5) / rows_;
  for (int i = 0; i < columns_; ++i) {
    const double u = (i + 0.5) / columns_;
    const auto& [m, a] = element;
    const RepeatingPlace place{
        RepeatingReach((m[0] * u + m[1] * v + a[0]) * columns_ - 0.5, columns_),
        RepeatingReach((m[2] * u + m[3] * v + a[1]) * rows_ - 0.5, rows_)};
    const std::size_t to = static_cast<std::size_t>(row) * columns_ + i;
    for (int c = 0; c < 3; ++c) symmetric_[c][to] += share * place.of(planes_[c], columns_);
  }
}

}  // namespace seamwise
