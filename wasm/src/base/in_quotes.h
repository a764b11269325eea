#pragma once
#include <string>

namespace seamwise {

/// The text on one line: control characters and line separators of any kind are written as escapes
/// ("\n", "\u0085").
std::string onOneLine(const std::string& text);

/// A name from a file as messages show it: in quotes, on one line, shortened when it is absurdly
/// long. UTF-8 in and out.
std::string inQuotes(const std::string& name);

}  // namespace seamwise
