#include "base/sort_by.h"

#include <algorithm>

namespace seamwise {

void sortNumbers(std::vector<double>& numbers) {
  std::vector<std::pair<double, std::size_t>> items;
  items.reserve(numbers.size());
  for (const double number : numbers) items.emplace_back(number, 0);
  sortKeyed(items);
  for (std::size_t k = 0; k < items.size(); ++k) numbers[k] = items[k].first;
}

void sortKeyed(std::vector<std::pair<double, std::size_t>>& items) {
  std::sort(items.begin(), items.end());
}

void sortOnce(std::vector<std::pair<int, int>>& pairs) {
  constexpr double kIndices = 1 << 26;
  std::vector<double> keys;
  keys.reserve(pairs.size());
  for (const auto& [first, second] : pairs) keys.push_back(first * kIndices + second);
  sortNumbers(keys);
  std::size_t count = 0;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    if (k > 0 && keys[k] == keys[k - 1]) continue;
    const int first = static_cast<int>(keys[k] / kIndices);
    pairs[count++] = {first, static_cast<int>(keys[k] - first * kIndices)};
  }
  pairs.resize(count);
}

std::vector<std::size_t> placesInOrder(const std::vector<double>& keys) {
  std::vector<std::pair<double, std::size_t>> order;
  order.reserve(keys.size());
  for (const double key : keys) order.emplace_back(key, order.size());
  sortKeyed(order);
  std::vector<std::size_t> places;
  places.reserve(keys.size());
  for (const auto& [key, place] : order) places.push_back(place);
  return places;
}

}  // namespace seamwise
