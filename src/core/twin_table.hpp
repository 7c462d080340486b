// Owns a table of numbers in double and in float, for lanes of either.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/lanes.hpp"

namespace photic {

class TwinTable {
 public:
  TwinTable() = default;
  explicit TwinTable(std::span<const double> numbers) { append(numbers); }

  void append(std::span<const double> numbers) {
    std::size_t i = exact_.size();  // a medium of many layers appends hundreds of tables
    exact_.insert(exact_.end(), numbers.begin(), numbers.end());
    rounded_.resize((exact_.size() / table_padding + 1) * table_padding, 0.0F);
    for (; i < exact_.size(); ++i) rounded_[i] = static_cast<float>(exact_[i]);
  }

  [[nodiscard]] Table table() const { return {exact_.data(), rounded_.data()}; }
  [[nodiscard]] ShortTable view() const {
    return {table(), static_cast<std::int32_t>(exact_.size())};
  }
  [[nodiscard]] std::span<const double> numbers() const { return exact_; }

 private:
  std::vector<double> exact_;
  std::vector<float> rounded_;
};

/// Owns two tables of the same length.
class TwinPairs {
 public:
  TwinPairs() = default;
  TwinPairs(std::span<const double> first, std::span<const double> second)
      : first_(first), second_(second) {
    std::vector<double> rows;
    for (std::size_t i = 0; i < first.size(); ++i) rows.insert(rows.end(), {first[i], second[i]});
    rows_ = TwinTable(rows);
  }

  [[nodiscard]] ShortPairs view() const { return {first_.view(), second_.view(), rows_.table()}; }

 private:
  TwinTable first_, second_, rows_;
};

/// Owns a short table of integers.
class IndexTableOwner {
 public:
  IndexTableOwner() = default;
  explicit IndexTableOwner(std::span<const std::int32_t> numbers)
      : size_(numbers.size()), data_((size_ / table_padding + 1) * table_padding) {
    for (std::size_t i = 0; i < size_; ++i) data_[i] = numbers[i];
  }
  [[nodiscard]] IndexTable view() const { return {data_.data(), static_cast<std::int32_t>(size_)}; }

 private:
  std::size_t size_ = 0;
  std::vector<std::int32_t> data_;
};

}  // namespace photic
