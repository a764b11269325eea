#pragma once
#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace seamwise {

// Words in piece names, in the languages of the page, in lower case and cut off at accented
// letters.
inline constexpr std::array<std::string_view, 5> kSleeveWords = {"sleeve", "rmel", "manche",
                                                                 "manga", "manica"};
inline constexpr std::array<std::string_view, 5> kFrontWords = {"front", "vorder", "devant",
                                                                "delanter", "davanti"};
inline constexpr std::array<std::string_view, 5> kBackWords = {"back", "cken", "dos", "espalda",
                                                               "dietro"};
inline constexpr std::array<std::string_view, 5> kBandWords = {"waistband", "bund", "ceinture",
                                                               "pretina", "cintur"};

/// Returns whether a piece name contains one of these words, ignoring ASCII case.
inline bool isCalled(std::string name, const std::array<std::string_view, 5>& words) {
  for (char& c : name)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + ('a' - 'A'));
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view word) { return name.find(word) != std::string::npos; });
}

}  // namespace seamwise
