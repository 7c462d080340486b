#include "optics/phase_key.hpp"

#include "core/error.hpp"

namespace photic::optics {

PhaseKey& PhaseKey::add(std::span<const double> numbers) {
  add_bytes(std::as_bytes(numbers));
  return *this;
}

PhaseKey& PhaseKey::add(std::string_view text) {
  expect(!text.empty(), "what a key is made of is known");
  add_bytes(std::as_bytes(std::span(text)));
  return *this;
}

void PhaseKey::add_bytes(std::span<const std::byte> bytes) {
  const auto append = [this](std::span<const std::byte> more) {
    for (const std::byte each : more) bytes_ += static_cast<char>(each);
  };
  const std::size_t length = bytes.size();
  append(std::as_bytes(std::span(&length, 1)));
  append(bytes);
}

}  // namespace photic::optics
