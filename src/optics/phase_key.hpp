// The identity of a phase function, by which equal ones share a table.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace photic::optics {

/// The maker of a phase function and all that it was made of, bit for bit: two of one key are the
/// same function. Empty: nobody knows, and it is like no other.
class PhaseKey {
 public:
  PhaseKey() = default;
  explicit PhaseKey(std::string_view maker) { add(maker); }

  PhaseKey& add(double number) { return add(std::span(&number, 1)); }
  PhaseKey& add(std::span<const double> numbers);
  /// Of a part. It must not be empty.
  PhaseKey& add(const PhaseKey& part) { return add(std::string_view(part.bytes_)); }

  [[nodiscard]] bool empty() const { return bytes_.empty(); }
  [[nodiscard]] std::size_t size() const { return bytes_.size(); }
  friend auto operator<=>(const PhaseKey&, const PhaseKey&) = default;

 private:
  PhaseKey& add(std::string_view text);
  /// Each piece has its length before it, so that no two lists of pieces have the same bytes.
  void add_bytes(std::span<const std::byte> bytes);

  std::string bytes_;
};

}  // namespace photic::optics
