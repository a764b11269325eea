#pragma once
#include <string>

namespace seamwise {

/// Returns the text on one line, with control characters and line separators of any kind as escapes
/// ("\n", "\u0085").
std::string onOneLine(const std::string& text);

/// Formats a name from a file for a message: in quotes, on one line, shortened if absurdly long.
/// UTF-8 in and out.
std::string inQuotes(const std::string& name);

}  // namespace seamwise
