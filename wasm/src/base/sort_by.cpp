#include "base/sort_by.h"

#include <algorithm>

namespace seamwise {

std::vector<std::size_t> placesInOrder(const std::vector<double>& keys) {
  std::vector<std::pair<double, std::size_t>> order;
  order.reserve(keys.size());
  for (const double key : keys) order.emplace_back(key, order.size());
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> places;
  places.reserve(keys.size());
  for (const auto& [key, place] : order) places.push_back(place);
  return places;
}

}  // namespace seamwise
