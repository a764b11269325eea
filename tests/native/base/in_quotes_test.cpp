#include "base/in_quotes.h"

#include <gtest/gtest.h>

namespace seamwise {
namespace {

TEST(InQuotes, LeavesPrintableTextAlone) {
  EXPECT_EQ(inQuotes("front"), "'front'");
  EXPECT_EQ(inQuotes("\xC3\x84rmel \xE8\xA2\x96"), "'\xC3\x84rmel \xE8\xA2\x96'");
}

TEST(InQuotes, WritesWhatEndsALineOrControlsATerminalAsEscapes) {
  EXPECT_EQ(inQuotes("front\nback"), "'front\\nback'");
  EXPECT_EQ(inQuotes(std::string("\0\r\x1B\x7F", 4)), "'\\u0000\\u000d\\u001b\\u007f'");
  EXPECT_EQ(inQuotes("\xC2\x85"), "'\\u0085'");
  EXPECT_EQ(inQuotes("\xE2\x80\xA8\xE2\x80\xA9"), "'\\u2028\\u2029'");
}

TEST(InQuotes, ShortensLongNamesBetweenCharacters) {
  EXPECT_EQ(inQuotes(std::string(60, 'x')), "'" + std::string(60, 'x') + "'");
  EXPECT_EQ(inQuotes(std::string(61, 'x')), "'" + std::string(60, 'x') + "...'");
  EXPECT_EQ(inQuotes(std::string(59, 'x') + "\xC3\x84"), "'" + std::string(59, 'x') + "...'");
}

TEST(OnOneLine, KeepsUnfinishedSequencesAsTheyAre) {
  EXPECT_EQ(onOneLine("a\xC2"), "a\xC2");
  EXPECT_EQ(onOneLine("a\xE2\x80"), "a\xE2\x80");
  EXPECT_EQ(onOneLine(""), "");
}

}  // namespace
}  // namespace seamwise
