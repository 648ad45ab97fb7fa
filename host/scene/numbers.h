#pragma once
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace laver {

/// A number read from text, or the reason why it is invalid.
template <class T>
struct Parsed {
  T value{};
  const char* problem = nullptr;  ///< "is not a number", ...: goes after the text in a message
  explicit operator bool() const { return problem == nullptr; }
};

/// Reads all of `text` as a decimal number, independently of the locale: sign, digits, point,
/// exponent. A number too small for a double is 0; one too large, NaN and infinities are errors.
Parsed<double> parseReal(std::string_view text);

/// Reads all of `text` as a decimal integer with an optional sign.
Parsed<std::int64_t> parseInteger(std::string_view text);

/// The pieces of `text` between white space and commas.
std::vector<std::string_view> splitList(std::string_view text);

/// Removes white space at both ends.
std::string_view trimmed(std::string_view text);

}  // namespace laver
