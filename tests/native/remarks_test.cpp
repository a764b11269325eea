#include "solve/remarks.h"

#include <gtest/gtest.h>

#include "solver_samples.h"

namespace seamwise::testing {
namespace {

std::vector<std::string> remarksAfter(const Task& t) {
  Outcome<Solver> solver = Solver::make(problemOf(t));
  EXPECT_TRUE(solver.ok()) << solver.error().message;
  return remarksOn(solver.value().pattern());
}

TEST(Remarks, NamesGatheredSeamsUntilTheyAreLeftOut) {
  Task t = task("gathered-skirt", "pmm");
  const auto remarks = remarksAfter(t);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_NE(remarks[0].find("'front' to 'waistband_front'"), std::string::npos) << remarks[0];
  t.options["unmatched"] = {4, 5};
  EXPECT_TRUE(remarksAfter(t).empty());
}

TEST(Remarks, SaysNothingOfASleevesEase) { EXPECT_TRUE(remarksAfter(task("tee", "pmm")).empty()); }

TEST(Remarks, SaysWhenNoSeamIsLeftToMatch) {
  Task t = task("tee", "pmm");
  for (const auto& [name, panel] : panelsOf(t.garment).items()) t.options["plain"].push_back(name);
  const auto remarks = remarksAfter(t);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_NE(remarks[0].find("plain"), std::string::npos) << remarks[0];
  t.garment["pattern"]["stitches"] = Json::array();
  t.options = Json::object();
  ASSERT_EQ(remarksAfter(t).size(), 1u);
  EXPECT_NE(remarksAfter(t)[0].find("no seams"), std::string::npos);
}

TEST(Remarks, AreNotesOfTheResult) {
  const Result r = solved(task("gathered-skirt", "p1"));
  EXPECT_TRUE(std::any_of(r.notes.begin(), r.notes.end(), [](const std::string& note) {
    return note.find("unmatched") != std::string::npos;
  }));
}

}  // namespace
}  // namespace seamwise::testing
