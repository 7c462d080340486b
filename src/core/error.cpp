#include "core/error.hpp"

#include <fmt/format.h>

namespace photic {
namespace {

/// A null byte would end the text of an exception.
std::string joined(const std::vector<Diagnostic>& diagnostics) {
  std::string out;
  for (const auto& d : diagnostics)
    for (const char c : d.text() + '\n')
      out += c == '\0' ? std::string("\\u0000") : std::string(1, c);
  if (!out.empty()) out.pop_back();
  return out;
}

}  // namespace

std::string Diagnostic::text() const {
  std::string place = file;
  if (line > 0) place += fmt::format(":{}:{}", line, column);
  if (!place.empty()) place += ": ";
  return place + reason + (suggestion.empty() ? "" : " (" + suggestion + ")");
}

InputError::InputError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(joined(diagnostics)), diagnostics_(std::move(diagnostics)) {}

void expect(bool condition, const char* promise) {
  if (!condition) throw ContractViolation(std::string("broken promise: ") + promise);
}

}  // namespace photic
