#include <gtest/gtest.h>

#include <fstream>

#include "support/garment_texts.h"

namespace seamwise {
namespace {

using testing::expectRefused;
using testing::twoRectangles;

/// The WebAssembly module, whose texts JavaScript reads, has to produce the same messages.
TEST(BrokenFile, ThatIsNotJsonIsShownWhereItBreaks) {
  std::ifstream file(std::string(SEAMWISE_FIXTURES) + "/broken-json.json");
  const Json cases = Json::parse(file);
  EXPECT_GT(cases.size(), 50u);
  for (const Json& one : cases) {
    const Outcome<GarmentFile> read = readGarment(one["text"].get<std::string>(), "shirt.json");
    ASSERT_FALSE(read.ok()) << one["text"];
    EXPECT_EQ(read.error().message, "shirt.json " + one["says"].get<std::string>()) << one["text"];
  }
}

TEST(BrokenFile, ThatEndsTooEarlyIsIncomplete) {
  expectRefused(std::string("{\"pattern\": {\"panels\": {"), Failure::kNotJson, {"not complete"});
}

TEST(BrokenFile, WithAZeroByteDoesNotEndThere) {
  const std::string text = twoRectangles().dump();
  expectRefused(text + std::string(1, '\0'), Failure::kNotJson, {"zero byte", "line 1"});
  expectRefused(text + std::string("\0{}", 3), Failure::kNotJson, {"zero byte", "line 1"});
}

TEST(BrokenFile, WithoutContentIsEmpty) {
  expectRefused(std::string(), Failure::kNotJson, {"is empty"});
  expectRefused(std::string(" \n\t"), Failure::kNotJson, {"is empty"});
  expectRefused(std::string("\xEF\xBB\xBF"), Failure::kNotJson, {"is empty"});
}

TEST(BrokenFile, WithNaNIsToldThatJsonHasNone) {
  std::string text = twoRectangles().dump();
  text.replace(text.find("[10,0]"), 6, "[NaN,0]");
  expectRefused(text, Failure::kNotJson, {"NaN and Infinity are not numbers in JSON", "line 1"});
}

TEST(BrokenFile, WithANumberBeyondAllNumbersIsShownWhere) {
  std::string text = twoRectangles().dump(1);
  text.replace(text.find("units_in_meter\": 100"), 20, "units_in_meter\": 1e999");
  expectRefused(text, Failure::kNumber, {"too large to be finite", "line"});
}

TEST(BrokenFile, OverTwentyMegabytesIsTooLarge) {
  expectRefused(std::string(20'000'001, ' '), Failure::kTooLarge, {"20 MB"});
}

TEST(BrokenFile, OfMillionsOfValuesIsTooLarge) {
  std::string text = "[";
  for (int i = 0; i < 3'000'001; ++i) text += "0,";
  expectRefused(text + "0]", Failure::kTooLarge, {"3 million"});
}

TEST(BrokenFile, ThatNestsWithoutEndDoesNotOverflow) {
  expectRefused(std::string(1'000'000, '['), Failure::kNotJson, {"nests"});
  std::string objects;
  for (int i = 0; i < 100'000; ++i) objects += "{\"a\":";
  expectRefused(objects, Failure::kNotJson, {"nests"});
}

}  // namespace
}  // namespace seamwise
