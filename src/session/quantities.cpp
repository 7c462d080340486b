#include "session/quantities.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace photic::session {
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

[[noreturn]] void refuse(const std::string& text, const std::string& reason) {
  throw std::invalid_argument(fmt::format("'{}' {}", text, reason));
}

double wavelength(const std::string& text) {
  const auto nm = measured(text);
  if (!nm || !nm->unit.empty()) refuse(text, "is not a wavelength in nm (write 532 or 400:700:10)");
  if (!(nm->number > 0)) refuse(text, "is not above 0 nm");
  return nm->number;
}

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == at)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

/// The wavelengths of "from:to:step": from, and every step on that does not pass to.
std::vector<double> wavelength_range(const std::string& text) {
  const auto parts = split(text, ':');
  if (parts.size() != 3) refuse(text, "is not from:to:step (write 400:700:10)");
  const double from = wavelength(parts[0]), to = wavelength(parts[1]), step = wavelength(parts[2]);
  if (to < from) refuse(text, "ends before it begins (write 400:700:10)");
  constexpr double rounding = 1e-9;  // of a step: 0.1 is not a whole part of anything
  const double steps = std::floor((to - from) / step + rounding);
  if (!(steps < max_wavelengths))
    refuse(text, fmt::format("is more than {} wavelengths", max_wavelengths));
  std::vector<double> out;
  for (int i = 0; i <= static_cast<int>(steps); ++i) out.push_back(from + i * step);
  return out;
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

std::vector<double> wavelengths_nm(const std::string& text) {
  std::vector<double> out;
  for (const std::string& item : split(text, ',')) {
    if (item.find(':') == std::string::npos) {
      out.push_back(wavelength(item));
    } else {
      const auto range = wavelength_range(item);
      out.insert(out.end(), range.begin(), range.end());
    }
  }
  if (out.size() > max_wavelengths)
    refuse(text, fmt::format("is more than {} wavelengths", max_wavelengths));
  for (std::size_t i = 1; i < out.size(); ++i) {
    if (out[i] == out[i - 1]) refuse(text, fmt::format("has {:g} nm twice", out[i]));
    if (out[i] < out[i - 1])
      refuse(text, fmt::format("is not ascending: {:g} nm follows {:g} nm", out[i], out[i - 1]));
  }
  return out;
}

std::string wavelength_value(const std::string& text) {
  return fmt::format("{}", wavelength(text));
}

}  // namespace photic::session
