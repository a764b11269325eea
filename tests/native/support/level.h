#pragma once

#include <cstdlib>
#include <cstring>
#include <vector>

namespace seamwise::testing {

/// Returns whether this is the thorough run, which sets SEAMWISE_TESTS=thorough.
inline bool isThorough() {
  const char* level = std::getenv("SEAMWISE_TESTS");
  return level && std::strcmp(level, "thorough") == 0;
}

/// The number of cases to try: `few` for a commit, `all` in the thorough run.
inline int cases(int few, int all) { return isThorough() ? all : few; }

/// The first `few` of all cases; all of them in the thorough run.
template <typename Case>
std::vector<Case> sampleOf(std::size_t few, std::vector<Case> all) {
  if (!isThorough() && all.size() > few) all.resize(few);
  return all;
}

}  // namespace seamwise::testing

/// Leaves a test to the thorough run.
#define SEAMWISE_THOROUGH_ONLY() \
  if (!::seamwise::testing::isThorough()) GTEST_SKIP() << "only in the thorough run"
