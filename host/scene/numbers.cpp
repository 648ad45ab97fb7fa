#include "scene/numbers.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

namespace laver {
namespace {

constexpr std::string_view kSpace = " \t\r\n\f\v";
constexpr const char* kNotANumber = "is not a number";
constexpr const char* kNotFinite = "is not a finite number";

// std::from_chars does not accept a leading '+'.
std::string_view withoutPlus(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+') text.remove_prefix(1);
  return text;
}

// Whether a well-formed decimal number that is out of range is too small rather than too large: the
// power of ten of its first nonzero digit, plus the exponent, is negative.
bool isTiny(std::string_view text) {
  const std::size_t e = text.find_first_of("eE");
  const std::string_view mantissa = text.substr(0, e);
  const std::size_t first = mantissa.find_first_of("123456789");
  if (first == std::string_view::npos) return true;
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  const double power = static_cast<double>(point) - static_cast<double>(first);
  double exponent = 0.0;
  if (e != std::string_view::npos) {
    const bool negative = text[e + 1] == '-';
    for (const char c : text.substr(e + 1)) {
      if (c >= '0' && c <= '9') exponent = exponent * 10.0 + (c - '0');
    }
    if (negative) exponent = -exponent;
  }
  return power + exponent < 0.0;
}

}  // namespace

Parsed<double> parseReal(std::string_view text) {
  const std::string_view digits = withoutPlus(text);
  double value = 0.0;
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  const std::string_view rest(stop, static_cast<std::size_t>(end - stop));
  if (rest.starts_with("#IND") || rest.starts_with("#INF") || rest.starts_with("#QNAN") ||
      rest.starts_with("#SNAN"))
    return {0.0, kNotFinite};  // as C libraries of Windows write it, behind "1."
  if (error == std::errc::invalid_argument || stop != end) return {0.0, kNotANumber};
  if (error == std::errc::result_out_of_range) {
    if (isTiny(digits)) return {0.0, nullptr};
    return {0.0, "is too large for a number"};
  }
  if (!std::isfinite(value)) return {0.0, kNotFinite};
  return {value, nullptr};
}

Parsed<std::int64_t> parseInteger(std::string_view text) {
  const std::string_view digits = withoutPlus(text);
  std::int64_t value = 0;
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (error == std::errc::invalid_argument || stop != end) return {0, "is not an integer"};
  if (error == std::errc::result_out_of_range) return {0, "is too large for an integer"};
  return {value, nullptr};
}

std::vector<std::string_view> splitList(std::string_view text) {
  std::vector<std::string_view> pieces;
  constexpr std::string_view kSeparators = " \t\r\n\f\v,";
  for (std::size_t begin = 0;;) {
    begin = text.find_first_not_of(kSeparators, begin);
    if (begin == std::string_view::npos) return pieces;
    const std::size_t end = std::min(text.find_first_of(kSeparators, begin), text.size());
    pieces.push_back(text.substr(begin, end - begin));
    begin = end;
  }
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kSpace);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kSpace) - begin + 1);
}

}  // namespace laver
