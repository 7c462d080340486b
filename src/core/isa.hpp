// Instruction sets of x86 that lanes are compiled for (cmake/photic.cmake), and which of them run
// here.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace photic {

/// From the least to the best.
enum class Isa { baseline, avx2, avx512 };
inline constexpr std::array isas{Isa::baseline, Isa::avx2, Isa::avx512};

const char* isa_name(Isa isa);
/// None if there is none of this name.
std::optional<Isa> isa_of(std::string_view name);
/// Returns whether lanes of this build are compiled for it.
bool is_built(Isa isa);
/// Returns whether this processor has it.
bool is_of_processor(Isa isa);
/// Returns whether this build has it, and this processor.
bool runs_here(Isa isa);
/// All that run here, from the least to the best; never none.
std::vector<Isa> isas_here();

}  // namespace photic
