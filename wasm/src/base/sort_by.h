#pragma once
#include <cstddef>
#include <utility>
#include <vector>

namespace seamwise {

// The standard library's sorts, one for every type and order, would each add 1 kB to a module,
// compressed. So there is one, sortKeyed, and all else is sorted by way of it.

/// Ascending, like the others.
void sortNumbers(std::vector<double>& numbers);
/// By number, then place.
void sortKeyed(std::vector<std::pair<double, std::size_t>>& items);
/// Leaves each pair once; both are in [0, 2^26).
void sortOnce(std::vector<std::pair<int, int>>& pairs);

/// The places of `keys` in ascending order, those of equal keys as they come.
std::vector<std::size_t> placesInOrder(const std::vector<double>& keys);

/// Sorts by key(item), a number; equal ones stay as they come.
template <class Item, class Key>
void sortBy(std::vector<Item>& items, Key key) {
  const std::size_t count = items.size();
  std::vector<double> keys(count);
  for (std::size_t k = 0; k < count; ++k) keys[k] = static_cast<double>(key(items[k]));
  const std::vector<std::size_t> places = placesInOrder(keys);
  std::vector<Item> sorted(count);
  for (std::size_t k = 0; k < count; ++k) sorted[k] = std::move(items[places[k]]);
  items = std::move(sorted);
}

}  // namespace seamwise
