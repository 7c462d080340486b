// Units as files name them.
#pragma once

#include <optional>
#include <string>

namespace photic::scene {

/// A power of ten times powers of grams, metres and pascals.
struct Unit {
  int decade = 0, gram = 0, metre = 0, pascal = 0;
};

/// The unit of a text as the field and udunits write it: "mg m-3", "ug/l", "milligrams per m^3",
/// "decibar". None for other texts.
[[nodiscard]] std::optional<Unit> unit_called(const std::string& text);

[[nodiscard]] std::string lower_case(std::string text);

/// With letters and digits of ASCII for micro signs, raised digits, degree signs and the like.
[[nodiscard]] std::string plain_text(std::string text);

}  // namespace photic::scene
