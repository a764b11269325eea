// The result of a search must not depend on where its shares run.
#include <gtest/gtest.h>

#include "alignment/search/search.h"
#include "io/share_numbers.h"
#include "support/cut_layout.h"
#include "support/level.h"
#include "support/meshed_samples.h"

namespace seamwise {
namespace {

using testing::matchProblem;
using testing::meshedPattern;
using testing::Random;
using testing::randomLeaders;
using testing::sampleGroup;

/// All results of a search.
struct Found {
  std::vector<Alignments> few;
  Alignments watched;
  double bound;
  bool operator==(const Found&) const = default;
};

/// Runs a share from its numbers alone, as a helper does.
std::vector<double> runElsewhere(const std::vector<double>& numbers) {
  const std::optional<ShareOrder> order = readShare(numbers);
  if (!order) return {};
  const std::vector<Component> components = componentsOf(order->problem);
  const SearchSamples samples = searchSamples(order->problem, order->task.budget);
  SearchShare share(order->problem, components, samples, order->task);
  while (share.step()) {
  }
  return writeAnswers(share.answers());
}

/// Runs some of the shares elsewhere.
class Elsewhere {
 public:
  /// @param lent   most shares that run elsewhere
  /// @param after   steps here before their answers arrive; negative: they never arrive
  Elsewhere(int lent, int after) : lent_(lent), after_(after) {}

  Found search(const MatchProblem& problem, double slack = 0) {
    AlignmentSearch search(problem, 7, {}, slack);
    if (slack == 0) search.watch(1.0);
    Random random(3);
    search.offer(randomLeaders(problem, random));
    std::vector<std::shared_ptr<AlignmentSearch::Share>> out;
    for (int k = 0; k < lent_; ++k)
      if (auto share = search.lend()) out.push_back(std::move(share));
    steps_ = 0;
    do {
      if (steps_ == after_)
        for (const auto& share : out)
          share->answers =
              readAnswers(runElsewhere(writeShare(problem, share->task)), componentsOf(problem));
      ++steps_;
    } while (search.step());
    return {search.bestFew(), search.watched(), search.bound()};
  }
  int steps() const { return steps_; }  ///< steps that ran here

 private:
  int lent_, after_, steps_ = 0;
};

/// A tee without and with symmetry, on prints that split it into one component or more, easy and
/// hard.
std::vector<std::pair<MatchProblem, std::string>> problems() {
  std::vector<std::pair<MatchProblem, std::string>> all;
  for (const char* name : testing::sampleOf<const char*>(2, {"pmm", "p31m", "p1"})) {
    const WallpaperGroup group = sampleGroup(*findGroup(name), 0.3);
    for (const bool mirrored : {false, true}) {
      if (mirrored && !group.carriesSingle()) continue;
      const Pattern pattern = meshedPattern(small::tee(1.5), mirrored);
      all.emplace_back(matchProblem(pattern, group), name);
    }
  }
  return all;
}

TEST(SharesOfASearch, FindTheSameWhereverTheyRun) {
  for (const auto& [problem, name] : problems()) {
    const Found alone = Elsewhere(0, 0).search(problem);
    for (const int lent : {1, 3})
      for (const int after : {0, 40})
        EXPECT_EQ(Elsewhere(lent, after).search(problem), alone) << name << ", " << lent;
  }
}

TEST(SharesOfASearch, FindTheSameUnderSlack) {
  for (const auto& [problem, name] : problems()) {
    const Found alone = Elsewhere(0, 0).search(problem, 1.0);
    EXPECT_EQ(Elsewhere(3, 20).search(problem, 1.0), alone) << name;
  }
}

TEST(SharesOfASearch, AreRunHereWhenTheyDoNotComeBack) {
  for (const auto& [problem, name] : problems())
    EXPECT_EQ(Elsewhere(4, -1).search(problem), Elsewhere(0, 0).search(problem)) << name;
}

TEST(SharesOfASearch, ThatRunElsewhereAreNotRunHere) {
  const MatchProblem problem =
      matchProblem(meshedPattern(small::tee(1.5), false), sampleGroup(*findGroup("p31m")));
  Elsewhere alone(0, 0), helped(3, 0);
  alone.search(problem), helped.search(problem);
  EXPECT_LT(helped.steps(), alone.steps() / 2);
}

TEST(ShareNumbers, RefuseWhatIsCutShortOrTooLong) {
  const MatchProblem problem =
      matchProblem(meshedPattern(small::tee(1.5), false), sampleGroup(*findGroup("pmm")));
  AlignmentSearch search(problem, 1, {});
  const std::vector<double> whole = writeShare(problem, search.lend()->task);
  ASSERT_TRUE(readShare(whole));
  for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 100)
    EXPECT_FALSE(readShare({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}));
  std::vector<double> more = whole;
  more.push_back(0);
  EXPECT_FALSE(readShare(more));
  const std::vector<double> answers = runElsewhere(whole);
  EXPECT_TRUE(readAnswers(answers, componentsOf(problem)));
  EXPECT_FALSE(readAnswers(answers, {})) << "of other components";
  EXPECT_FALSE(readAnswers({answers.begin(), answers.end() - 1}, componentsOf(problem)));
}

}  // namespace
}  // namespace seamwise
