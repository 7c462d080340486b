#include "schedule/engines.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace photic::schedule {

// Defined by lanes_isa.cpp and scalar_isa.cpp, compiled for each.
namespace baseline {
std::unique_ptr<Simulator> make_lane_simulator(const estimator::Model& model);
std::unique_ptr<Simulator> make_scalar_simulator(const estimator::Model& model);
}  // namespace baseline
namespace avx2 {
std::unique_ptr<Simulator> make_lane_simulator(const estimator::Model& model);
std::unique_ptr<Simulator> make_scalar_simulator(const estimator::Model& model);
}  // namespace avx2
namespace avx512 {
std::unique_ptr<Simulator> make_lane_simulator(const estimator::Model& model);
}

std::string engine_name(const std::optional<Isa>& lanes) {
  return lanes ? fmt::format("lanes ({})", isa_name(*lanes)) : "scalar";
}

std::optional<Isa> isa_of_engine(std::string_view engine) {
  for (const Isa isa : isas) {
    if (engine == engine_name(isa)) return isa;
  }
  return std::nullopt;
}

std::unique_ptr<Simulator> make_simulator(const estimator::Model& model,
                                          const std::optional<Isa>& lanes) {
  expect(!lanes || runs_here(*lanes), "lanes are made of instructions that the processor has");
#if defined(PHOTIC_WIDE_LANES)
  if (lanes == Isa::avx512) return avx512::make_lane_simulator(model);
  if (lanes == Isa::avx2) return avx2::make_lane_simulator(model);
  if (!lanes && runs_here(Isa::avx2)) return avx2::make_scalar_simulator(model);
#endif
  return lanes ? baseline::make_lane_simulator(model) : baseline::make_scalar_simulator(model);
}

}  // namespace photic::schedule
