#pragma once
#include <cstddef>
#include <utility>
#include <vector>

namespace seamwise {

// The standard library's sorts, one for every type and order, would each add 1 kB to a module,
// compressed. All sorting therefore uses a single one, sortKeyed.

/// Sorts in ascending order, like all functions here.
void sortNumbers(std::vector<double>& numbers);
/// Sorts by number, then by place.
void sortKeyed(std::vector<std::pair<double, std::size_t>>& items);
/// Sorts the pairs and removes duplicates; both numbers are in [0, 2^26).
void sortOnce(std::vector<std::pair<int, int>>& pairs);

/// Returns the places of `keys` in ascending order; equal keys keep their order.
std::vector<std::size_t> placesInOrder(const std::vector<double>& keys);

/// Sorts the items by `keys`, one per item; equal ones keep their order.
template <class Item>
void sortByKeys(std::vector<Item>& items, const std::vector<double>& keys) {
  const std::vector<std::size_t> places = placesInOrder(keys);
  std::vector<Item> sorted(items.size());
  for (std::size_t k = 0; k < sorted.size(); ++k) sorted[k] = std::move(items[places[k]]);
  items = std::move(sorted);
}

/// Sorts by key(item), a number; equal ones keep their order.
template <class Item, class Key>
void sortBy(std::vector<Item>& items, Key key) {
  std::vector<double> keys(items.size());
  for (std::size_t k = 0; k < keys.size(); ++k) keys[k] = static_cast<double>(key(items[k]));
  sortByKeys(items, keys);
}

}  // namespace seamwise
