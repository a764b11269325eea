#include <algorithm>
#include <unordered_set>
#include <vector>

#include "io/json_input.h"

namespace seamwise {
namespace {

constexpr std::size_t kMaxDepth = 100;  // real files nest 7 deep; recursion over the tree is safe
constexpr std::size_t kMaxValues = 3'000'000;  // 20 MB of "[]" would otherwise need gigabytes

std::string lineAndColumn(std::string_view text, std::size_t position) {
  const std::string_view before = text.substr(0, std::min(position, text.size()));
  const std::size_t line =
      1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
  const std::size_t newline = before.rfind('\n');
  const std::size_t column = newline == before.npos ? before.size() : before.size() - newline - 1;
  return "line " + std::to_string(line) + ", column " +
         std::to_string(std::max<std::size_t>(column, 1));
}

/// Builds the document while it checks depth, size and names that occur twice.
class Builder {
 public:
  using number_integer_t = Json::number_integer_t;
  using number_unsigned_t = Json::number_unsigned_t;
  using number_float_t = Json::number_float_t;
  using string_t = Json::string_t;
  using binary_t = Json::binary_t;

  Builder(std::string_view text, const Place& place) : text_(text), place_(place) {}

  bool null() { return add(nullptr), true; }
  bool boolean(bool value) { return add(value), true; }
  bool number_integer(number_integer_t value) { return add(value), true; }
  bool number_unsigned(number_unsigned_t value) { return add(value), true; }
  bool number_float(number_float_t value, const string_t&) { return add(value), true; }
  bool string(string_t& value) { return add(std::move(value)), true; }
  bool binary(binary_t&) { return false; }
  bool start_object(std::size_t) {
    open(Json::object());
    names_.emplace_back();
    return true;
  }
  bool end_object() {
    names_.pop_back();
    open_.pop_back();
    return true;
  }
  bool start_array(std::size_t) { return open(Json::array()), true; }
  bool end_array() { return open_.pop_back(), true; }

  bool key(string_t& name) {
    if (!names_.back().insert(name).second)
      place_.fail(place_.shape, "has two entries named " + inQuotes(name) + inParent() +
                                    "; rename or remove one of them");
    // Appended without the linear search of ordered_map, which would be quadratic.
    open_.back()->get_ref<Json::object_t&>().emplace_back(std::move(name), nullptr);
    return true;
  }

  bool parse_error(std::size_t position, const std::string&, const Json::exception& error) {
    constexpr int kNumberOverflow = 406;
    const std::string where = lineAndColumn(text_, position);
    if (error.id == kNumberOverflow)
      place_.fail(place_.number,
                  "has a number that is too large to be finite at " + where + "; correct it");
    const std::string_view rest =
        text_.substr(std::min(text_.size(), position > 0 ? position - 1 : 0));
    // The token starts up to a letter or two before the place at which the parser gave up.
    const std::string_view near = text_.substr(position > 9 ? position - 9 : 0, 18);
    if (near.find("NaN") != near.npos || near.find("nan") != near.npos ||
        near.find("Inf") != near.npos || near.find("inf") != near.npos)
      place_.fail(Failure::kNotJson, "is not JSON at " + where +
                                         ": NaN and Infinity are not numbers in JSON; "
                                         "write a finite number or remove the field");
    if (rest.empty() || position > text_.size())
      place_.fail(Failure::kNotJson,
                  "is not complete JSON: it ends at " + where + "; save it again");
    place_.fail(Failure::kNotJson,
                "is not JSON: unexpected characters at " + where + "; correct it there");
  }

  Json take() { return std::move(root_); }

 private:
  Json* add(Json value) {
    if (++values_ > kMaxValues)
      place_.fail(Failure::kTooLarge, "has more than 3 million values; split it");
    if (open_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    Json& parent = *open_.back();
    if (parent.is_array()) {
      auto& items = parent.get_ref<Json::array_t&>();
      items.push_back(std::move(value));
      return &items.back();
    }
    Json& member = parent.get_ref<Json::object_t&>().back().second;
    member = std::move(value);
    return &member;
  }

  void open(Json container) {
    if (open_.size() >= kMaxDepth)
      place_.fail(Failure::kNotJson,
                  "nests more than 100 lists or objects; it is no file of this program");
    open_.push_back(add(std::move(container)));
  }

  /// " in 'panels'", for the object that is open.
  std::string inParent() const {
    if (open_.size() < 2) return "";
    const Json& outer = *open_[open_.size() - 2];
    return outer.is_object()
               ? " in " + inQuotes(outer.get_ref<const Json::object_t&>().back().first)
               : "";
  }

  std::string_view text_;
  const Place& place_;
  Json root_;
  std::vector<Json*>
      open_;  // the last child of an open container is the only one that still changes
  std::vector<std::unordered_set<std::string>> names_;
  std::size_t values_ = 0;
};

}  // namespace

Json parseDocument(std::string_view text, const Place& place) {
  if (text.size() > kMaxFileBytes)
    place.fail(Failure::kTooLarge, "is larger than 20 MB; split it or remove what is not needed");
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  std::string_view content = text;
  if (content.substr(0, kMark.size()) == kMark) content.remove_prefix(kMark.size());
  if (content.find_first_not_of(" \t\r\n") == content.npos)
    place.fail(Failure::kNotJson, "is empty; choose another file");
  // the parser would take it for the end and leave out the rest
  if (const std::size_t end = content.find('\0'); end != content.npos)
    place.fail(Failure::kNotJson, "is not JSON: it holds a zero byte at " +
                                      lineAndColumn(content, end + 1) + "; save it again");
  Builder builder(content, place);
  if (!Json::sax_parse(content.begin(), content.end(), &builder))
    place.fail(Failure::kNotJson, "is not JSON; save it again");
  return builder.take();
}

}  // namespace seamwise
