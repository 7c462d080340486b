#include "core/isa.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace photic {
namespace {

constexpr std::array names{"baseline", "avx2", "avx512"};

}  // namespace

const char* isa_name(Isa isa) { return names.at(static_cast<std::size_t>(isa)); }

std::optional<Isa> isa_of(std::string_view name) {
  for (const Isa isa : isas) {
    if (name == isa_name(isa)) return isa;
  }
  return std::nullopt;
}

bool is_built(Isa isa) {
#if defined(PHOTIC_ISA_AVX2)
  if (isa == Isa::avx2) return true;
#endif
#if defined(PHOTIC_ISA_AVX512)
  if (isa == Isa::avx512) return true;
#endif
  return isa == Isa::baseline;
}

bool is_of_processor(Isa isa) {
#if defined(__x86_64__)
  // The extensions that the files are compiled with: cmake/photic.cmake, cmake/isas.cmake.
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
  return isa == Isa::baseline || (avx2 && (isa == Isa::avx2 || avx512));
#else
  return isa == Isa::baseline;
#endif
}

bool runs_here(Isa isa) { return is_built(isa) && is_of_processor(isa); }

std::vector<Isa> isas_here() {
  std::vector<Isa> out;
  std::copy_if(isas.begin(), isas.end(), std::back_inserter(out), runs_here);
  return out;
}

}  // namespace photic
