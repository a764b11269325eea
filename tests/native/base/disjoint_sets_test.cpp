#include "base/disjoint_sets.h"

#include <gtest/gtest.h>

namespace seamwise {
namespace {

TEST(DisjointSets, NameASetByItsLeastMemberOverLongChains) {
  DisjointSets sets(6);
  for (const int k : {3, 2, 1, 0}) sets.join(k, k + 1);
  EXPECT_EQ(sets.find(4), 0);
  for (const int k : {0, 1, 2, 3}) EXPECT_EQ(sets.find(k), 0);
  EXPECT_EQ(sets.find(5), 5);
}

}  // namespace
}  // namespace seamwise
