// A field of comma-separated values.
#pragma once

#include <string>

namespace photic::io {

/// RFC 4180, section 2: quotes where needed, a quote within is doubled.
inline std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"#\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

}  // namespace photic::io
