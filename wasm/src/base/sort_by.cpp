#include "base/sort_by.h"

#include <algorithm>

namespace seamwise {

void sortNumbers(std::vector<double>& numbers) {
  std::vector<std::pair<double, std::size_t>> items(numbers.size());
  for (std::size_t k = 0; k < items.size(); ++k) items[k].first = numbers[k];
  sortKeyed(items);
  for (std::size_t k = 0; k < items.size(); ++k) numbers[k] = items[k].first;
}

/// Merges runs, each twice as long as the previous ones.
void sortKeyed(std::vector<std::pair<double, std::size_t>>& items) {
  std::vector<std::pair<double, std::size_t>> merged(items.size());
  const std::size_t count = items.size();
  for (std::size_t run = 1; run < count; run *= 2) {
    for (std::size_t from = 0; from < count; from += 2 * run) {
      const std::size_t middle = std::min(from + run, count), end = std::min(middle + run, count);
      std::size_t left = from, right = middle;
      for (std::size_t k = from; k < end; ++k) {
        const bool takes_right = left == middle || (right < end && items[right] < items[left]);
        merged[k] = items[takes_right ? right++ : left++];
      }
    }
    items.swap(merged);
  }
}

void sortOnce(std::vector<std::pair<int, int>>& pairs) {
  constexpr double kIndices = 1 << 26;
  std::vector<double> keys(pairs.size());
  for (std::size_t k = 0; k < keys.size(); ++k)
    keys[k] = pairs[k].first * kIndices + pairs[k].second;
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
  std::vector<std::pair<double, std::size_t>> order(keys.size());
  for (std::size_t k = 0; k < keys.size(); ++k) order[k] = {keys[k], k};
  sortKeyed(order);
  std::vector<std::size_t> places(keys.size());
  for (std::size_t k = 0; k < keys.size(); ++k) places[k] = order[k].second;
  return places;
}

}  // namespace seamwise
