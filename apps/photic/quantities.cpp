#include "photic/quantities.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace photic::app {
namespace {

constexpr double two_to_63 = 9223372036854775808.0;  // TOML's integers end below it

struct Measured {
  double number = 0;
  std::string_view unit;
};

/// The number at the head of the text and what follows it.
std::optional<Measured> measured(std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || !std::isfinite(number)) return std::nullopt;
  return Measured{number, text.substr(static_cast<std::size_t>(end - text.data()))};
}

std::optional<std::int64_t> whole(std::string_view text) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc{} && end == text.data() + text.size()) return number;
  const auto real = measured(text);
  if (!real || !real->unit.empty() || std::trunc(real->number) != real->number ||
      std::abs(real->number) >= two_to_63) {
    return std::nullopt;
  }
  return static_cast<std::int64_t>(real->number);
}

[[noreturn]] void refuse(const std::string& text, const char* reason) {
  throw std::invalid_argument(fmt::format("'{}' {}", text, reason));
}

}  // namespace

std::string photons_value(const std::string& text) {
  const auto number = whole(text);
  if (!number || *number < 1)
    refuse(text, "is not a whole number from 1 to 2^63 - 1 (write 10000000 or 1e7)");
  return fmt::format("{}", *number);
}

std::string share_value(const std::string& text) {
  const auto value = measured(text);
  if (!value || !(value->unit.empty() || value->unit == "%"))
    refuse(text, "is not a share (write 1% or 0.01)");
  const double share = value->unit == "%" ? value->number / 100.0 : value->number;
  if (!(share > 0 && share < 1)) refuse(text, "is not between 0 and 100 % (write 1% or 0.01)");
  return fmt::format("{}", share);
}

double seconds(const std::string& text) {
  const Measured value = measured(text).value_or(Measured{});
  const double scale = value.unit == "s"     ? 1.0
                       : value.unit == "min" ? 60.0
                       : value.unit == "h"   ? 3600.0
                                             : 0.0;
  if (scale == 0.0) refuse(text, "is not a time with its unit (write 60s, 10min or 2h)");
  if (!(value.number > 0)) refuse(text, "is not above 0 (write 60s, 10min or 2h)");
  return value.number * scale;
}

std::string seconds_value(const std::string& text) { return fmt::format("{}", seconds(text)); }

double bench_seconds(const std::string& text) {
  const double time = seconds(text);
  if (!(time >= 1 && time <= 86400)) refuse(text, "is not from 1s to 24h");
  return time;
}

std::string seed_value(const std::string& text) {
  const auto number = whole(text);
  if (!number || *number < 0) refuse(text, "is not a whole number from 0 to 2^63 - 1");
  return fmt::format("{}", *number);
}

}  // namespace photic::app
