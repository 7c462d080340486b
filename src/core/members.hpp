// The number of members of a record, counted at compile time.
#pragma once

#include <concepts>
#include <cstddef>
#include <type_traits>

namespace photic {

struct MemberCount {
  std::size_t reals = 0, integers = 0;
  [[nodiscard]] constexpr std::size_t all() const { return reals + integers; }
};

/// The same record of one lane, in double.
template <class Record>
struct OfOneLane;
template <template <class> class Record, class T>
struct OfOneLane<Record<T>> {
  using type = Record<double>;
};

/// The members of a Record<T>, which calls f(member) for each of its reals (T) and integers in
/// each_member(f).
template <class Record>
constexpr MemberCount count_members() {
  MemberCount count;
  typename OfOneLane<Record>::type record{};
  const auto one_more = [&count]<class M>(const M&) {
    ++(std::floating_point<M> ? count.reals : count.integers);
  };
  record.each_member(one_more);
  return count;
}

/// The most members of a Record<T>, which may leave some out where all have the same.
template <class Record>
inline constexpr MemberCount members_of = count_members<Record>();

}  // namespace photic
