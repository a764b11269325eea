#include <set>
#include <vector>

#include "base/decimal.h"
#include "io/json_ends.h"
#include "io/json_input.h"

namespace seamwise {
namespace {

constexpr std::size_t kMaxDepth = 100;  // real files nest 7 deep

/// @param within   the members around the defect, as ", in 'vertices' of 'front'"
Nothing failFor(const JsonDocument& document, const std::string& within, const Place& place) {
  const std::string where =
      "line " + decimal(document.line) + ", column " + decimal(document.column);
  switch (document.defect) {
    case JsonDefect::kTooLarge:
      return place.fail(Failure::kTooLarge,
                        "is larger than 20 MB; split it or remove what is not needed");
    case JsonDefect::kEmpty:
      return place.fail(Failure::kNotJson, "is empty; choose another file");
    case JsonDefect::kZeroByte:
      return place.fail(Failure::kNotJson,
                        "is not JSON: it holds a zero byte at " + where + "; save it again");
    case JsonDefect::kOverflow:
      return place.fail(place.number, "has a number that is too large to be finite at " + where +
                                          within + "; correct it");
    case JsonDefect::kNoNumber:
      return place.fail(Failure::kNotJson, "is not JSON at " + where +
                                               ": NaN and Infinity are not numbers in JSON; "
                                               "write a finite number or remove the field");
    case JsonDefect::kIncomplete:
      return place.fail(Failure::kNotJson,
                        "is not complete JSON: it ends at " + where + "; save it again");
    case JsonDefect::kUnexpected:
    case JsonDefect::kNone:
      break;
  }
  return place.fail(Failure::kNotJson,
                    "is not JSON: unexpected characters at " + where + "; correct it there");
}

/// Checks depth, size and duplicate names in the order of the text, up to the first defect.
class Check {
 public:
  Check(const JsonDocument& document, const Place& place) : document_(document), place_(place) {}

  void run() {
    for (at_ = 0; at_ < document_.nodes.size() && !place_.failed(); ++at_) {
      leaveEnded();
      if (!open_.empty() && open_.back().expects_name)
        name();
      else
        value();
    }
    leaveEnded();
  }

  /// The members that the document has not closed, as ", in 'vertices' of 'front'".
  std::string within() const {
    std::string words;
    for (auto open = open_.rbegin(); open != open_.rend(); ++open) {
      if (!open->is_object || open->name == 0) continue;
      const bool is_second = !words.empty();
      words += (is_second ? " of " : ", in ") + nameOf(*open);
      if (is_second) break;  // two names identify the panel and its member
    }
    return words;
  }

 private:
  struct Open {
    std::size_t at = 0;
    bool is_object = false, expects_name = false;
    std::size_t name = 0;  ///< node of the last name
    std::set<std::string_view> names = {};
  };

  void leaveEnded() {
    while (!open_.empty() && document_.nodes[open_.back().at].after == at_) open_.pop_back();
  }

  void name() {
    Open& object = open_.back();
    const std::string_view name = document_.text(document_.nodes[at_]);
    if (!object.names.insert(name).second)
      place_.fail(place_.shape, "has two entries named " + inQuotes(std::string(name)) +
                                    inParent() + "; rename or remove one of them");
    object.name = at_;
    object.expects_name = false;
  }

  void value() {
    if (++values_ > kMaxValues) {
      place_.fail(Failure::kTooLarge, "has more than 3 million values; split it");
      return;
    }
    if (!open_.empty()) open_.back().expects_name = open_.back().is_object;
    const JsonNode& node = document_.nodes[at_];
    const bool is_object = node.kind == JsonKind::kObject;
    if (!is_object && node.kind != JsonKind::kList) return;
    if (open_.size() >= kMaxDepth) {
      place_.fail(Failure::kNotJson,
                  "nests more than 100 lists or objects; it is no file of this program");
      return;
    }
    open_.push_back({at_, is_object, is_object});
  }

  /// The parent of the open object, as " in 'panels'".
  std::string inParent() const {
    if (open_.size() < 2 || !open_[open_.size() - 2].is_object) return "";
    return " in " + nameOf(open_[open_.size() - 2]);
  }

  /// The quoted name of the object's last member.
  std::string nameOf(const Open& object) const {
    return inQuotes(std::string(document_.text(document_.nodes[object.name])));
  }

  const JsonDocument& document_;
  const Place& place_;
  std::size_t at_ = 0, values_ = 0;
  std::vector<Open> open_;
};

}  // namespace

JsonDocument parseDocument(std::string_view text, const Place& place) {
  JsonDocument document = documentOf(text);
  Check check(document, place);
  check.run();
  if (document.defect != JsonDefect::kNone) failFor(document, check.within(), place);
  return document;
}

}  // namespace seamwise
