#include "base/memo.h"

#include <gtest/gtest.h>

namespace seamwise {
namespace {

TEST(Memo, ForgetsTheOldestOutcome) {
  Memo<int, int, 2> memo;
  for (const int k : {1, 2, 3}) memo.add(k, 10 * k);
  EXPECT_EQ(memo.find(1), nullptr);
  for (const int k : {2, 3}) {
    ASSERT_NE(memo.find(k), nullptr);
    EXPECT_EQ(*memo.find(k), 10 * k);
  }
}

}  // namespace
}  // namespace seamwise
