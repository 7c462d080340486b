// Letters of a text in UTF-8 (RFC 3629), which may take several bytes each.
#pragma once

#include <cstddef>
#include <string_view>

namespace photic {

/// Returns whether a byte goes on with the letter before it.
constexpr bool continues_letter(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// The number of letters.
constexpr std::size_t letters(std::string_view text) {
  std::size_t count = 0;
  for (const char c : text) count += continues_letter(c) ? 0 : 1;
  return count;
}

/// The first `count` letters, or all of them.
constexpr std::string_view first_letters(std::string_view text, std::size_t count) {
  std::size_t bytes = 0;
  while (bytes < text.size() && (continues_letter(text[bytes]) || count-- > 0)) ++bytes;
  return text.substr(0, bytes);
}

}  // namespace photic
