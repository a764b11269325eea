#pragma once

#include <cstdlib>
#include <cstring>
#include <vector>

namespace seamwise::testing {

/// The first `few` of all cases; all of them in the thorough run, which sets
/// SEAMWISE_TESTS=thorough.
template <typename Case>
std::vector<Case> sampleOf(std::size_t few, std::vector<Case> all) {
  const char* level = std::getenv("SEAMWISE_TESTS");
  const bool is_thorough = level && std::strcmp(level, "thorough") == 0;
  if (!is_thorough && all.size() > few) all.resize(few);
  return all;
}

}  // namespace seamwise::testing
