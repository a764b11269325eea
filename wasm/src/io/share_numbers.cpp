#include "io/share_numbers.h"

#include <array>
#include <type_traits>
#include <utility>

namespace seamwise {
namespace {

/// A sequence of numbers that is either written or read. One exchange() function per type lists its
/// members and serves both directions.
class Numbers {
 public:
  Numbers() = default;
  explicit Numbers(const std::vector<double>& numbers) : all_(numbers), reads_(true) {}

  template <class... Ts>
  void operator()(Ts&... values) {
    (one(values), ...);
  }
  /// Exchanges a list's size. A read size above the count of remaining numbers is invalid.
  template <class T>
  void resize(std::vector<T>& list) {
    double size = static_cast<double>(list.size());
    number(size);
    if (!reads_) return;
    broken_ = broken_ || !(size >= 0 && size <= static_cast<double>(all_.size() - next_));
    list.resize(broken_ ? 0 : static_cast<std::size_t>(size));
  }
  bool isWhole() const { return !broken_ && next_ == all_.size(); }
  std::vector<double> written() && { return std::move(all_); }

 private:
  void number(double& value) {
    if (!reads_) return all_.push_back(value);
    broken_ = broken_ || next_ == all_.size();
    value = broken_ ? 0 : all_[next_++];
  }
  template <class T>
  void one(T& value) {
    if constexpr (std::is_same_v<T, double>) {
      number(value);
    } else if constexpr (std::is_same_v<T, int> || std::is_same_v<T, bool>) {
      double as_number = static_cast<double>(value);
      number(as_number);
      value = static_cast<T>(as_number);
    } else {
      exchange(*this, value);
    }
  }

  std::vector<double> all_;
  bool reads_ = false, broken_ = false;
  std::size_t next_ = 0;
};

void exchange(Numbers& with, Vec2& v) { with(v.x(), v.y()); }

void exchange(Numbers& with, Mat2& m) { with(m(0, 0), m(0, 1), m(1, 0), m(1, 1)); }

void exchange(Numbers& with, Alignment& at) { with(at.angle, at.translation); }

void exchange(Numbers& with, Element& e) { with(e.A, e.a, e.mirrored, e.angle); }

void exchange(Numbers& with, AdmissibleAlignments::Place& place) {
  with(place.angle, place.on_line, place.along, place.period, place.spacing);
}

void exchange(Numbers& with, Leader& leader) {
  with(leader.piece, leader.admissible, leader.centre, leader.seams);
}

void exchange(Numbers& with, Stretch& stretch) {
  with(stretch.mean_a, stretch.mean_b, stretch.covariance);
}

void exchange(Numbers& with, MatchSeam& s) {
  with(s.a, s.b, s.reversing, s.pa, s.pb, s.da, s.db, s.w, s.weight, s.whole, s.seam, s.limit);
}

void exchange(Numbers& with, SearchBudget& b) {
  with(b.trees, b.idle, b.hits, b.evaluations, b.samples, b.shares);
}

void exchange(Numbers& with, std::pair<double, Alignments>& answer) {
  with(answer.first, answer.second);
}

void exchange(Numbers& with, Answers& answers) {
  with(answers.few, answers.watched_cost, answers.watched);
}

void exchange(Numbers& with, const GroupData*& group) {
  double index = static_cast<double>(group - wallpaperGroups().data());
  with(index);
  const double count = static_cast<double>(wallpaperGroups().size());
  if (index >= 0 && index < count) group = &wallpaperGroups()[static_cast<std::size_t>(index)];
}

/// A double cannot represent 64 bits, so two numbers are exchanged.
void exchange(Numbers& with, std::uint64_t& bits) {
  double high = static_cast<double>(bits >> 32), low = static_cast<double>(bits & 0xffffffffu);
  with(high, low);
  bits = static_cast<std::uint64_t>(high) << 32 | static_cast<std::uint64_t>(low);
}

template <class T>
void exchange(Numbers& with, std::array<T, 2>& two) {
  with(two[0], two[1]);
}

template <class T>
void exchange(Numbers& with, std::vector<T>& list) {
  with.resize(list);
  for (T& item : list) with(item);
}

template <class T>
requires requires(T& value, Numbers& with) { value.fields(with); }
void exchange(Numbers& with, T& value) { value.fields(with); }

void exchange(Numbers& with, ShareOrder& order) {
  MatchProblem& problem = order.problem;
  ShareTask& task = order.task;
  with(problem.leaders, problem.seams, problem.group, problem.continuous_only);
  with(task.budget, task.seed, task.slack, task.watched, task.at, task.known);
}

/// A placeholder; reading overwrites it.
WallpaperGroup plainGroup() { return WallpaperGroup::make("p1", {1, 0}, {0, 1}).value(); }

}  // namespace

std::vector<double> writeShare(const MatchProblem& problem, const ShareTask& task) {
  ShareOrder order{problem, task};
  Numbers numbers;
  numbers(order);
  return std::move(numbers).written();
}

std::optional<ShareOrder> readShare(const std::vector<double>& numbers) {
  ShareOrder order{MatchProblem(plainGroup()), {}};
  Numbers reader(numbers);
  reader(order);
  if (!reader.isWhole()) return std::nullopt;
  return order;
}

std::vector<double> writeAnswers(const std::vector<Answers>& answers) {
  std::vector<Answers> copy = answers;
  Numbers numbers;
  numbers(copy);
  return std::move(numbers).written();
}

std::optional<std::vector<Answers>> readAnswers(const std::vector<double>& numbers,
                                                const std::vector<Component>& components) {
  std::vector<Answers> answers;
  Numbers reader(numbers);
  reader(answers);
  if (!reader.isWhole() || answers.size() != components.size()) return std::nullopt;
  for (std::size_t k = 0; k < answers.size(); ++k) {
    const std::size_t size = components[k].leaders.size();
    if (answers[k].few.empty()) return std::nullopt;
    for (const auto& [cost, own] : answers[k].few)
      if (own.size() != size) return std::nullopt;
    if (answers[k].watched_cost >= 0 && answers[k].watched.size() != size) return std::nullopt;
  }
  return answers;
}

}  // namespace seamwise
