#include "engine/lanes.hpp"

#include <fmt/format.h>

#include <array>

#include "core/error.hpp"

namespace photic::engine {
namespace {

constexpr std::array names{"baseline", "avx2", "avx512"};
constexpr std::array sets{Isa::baseline, Isa::avx2, Isa::avx512};

}  // namespace

// Defined by lanes_isa.cpp, compiled for each.
namespace baseline {
std::unique_ptr<Simulator> make_lanes(const Problem& problem);
}
namespace avx2 {
std::unique_ptr<Simulator> make_lanes(const Problem& problem);
}
namespace avx512 {
std::unique_ptr<Simulator> make_lanes(const Problem& problem);
}

const char* isa_name(Isa isa) { return names.at(static_cast<std::size_t>(isa)); }

std::optional<Isa> isa_of(std::string_view name) {
  for (const Isa isa : sets) {
    if (name == isa_name(isa)) return isa;
  }
  return std::nullopt;
}

std::string engine_name(const std::optional<Isa>& lanes) {
  return lanes ? fmt::format("lanes ({})", isa_name(*lanes)) : "scalar";
}

std::optional<Isa> isa_of_engine(std::string_view engine) {
  for (const Isa isa : sets) {
    if (engine == engine_name(isa)) return isa;
  }
  return std::nullopt;
}

#if defined(__x86_64__)

bool runs_here(Isa isa) {
  // What the files are compiled with: cmake/photic.cmake.
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
  return isa == Isa::baseline || (avx2 && (isa == Isa::avx2 || avx512));
}

std::unique_ptr<Simulator> make_lanes(const Problem& problem, Isa isa) {
  expect(runs_here(isa), "lanes are made of instructions that the processor has");
  if (isa == Isa::avx512) return avx512::make_lanes(problem);
  if (isa == Isa::avx2) return avx2::make_lanes(problem);
  return baseline::make_lanes(problem);
}

#else

bool runs_here(Isa isa) { return isa == Isa::baseline; }

std::unique_ptr<Simulator> make_lanes(const Problem& problem, Isa isa) {
  expect(runs_here(isa), "lanes are made of instructions that the processor has");
  return baseline::make_lanes(problem);
}

#endif

Isa best_isa() {
  if (runs_here(Isa::avx512)) return Isa::avx512;
  return runs_here(Isa::avx2) ? Isa::avx2 : Isa::baseline;
}

}  // namespace photic::engine
