#include "schedule/engines.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "schedule/engine_parts.hpp"

namespace photic::schedule {
namespace {

template <class Kind>
std::unique_ptr<Simulator> make(const estimator::Model& model) {
  using Parts = EngineParts<Kind>;
  switch (model.scene.simulation.estimator) {
    case scene::Estimator::bidirectional:
      return Parts::walks_simulator(model, Parts::beside_walks_simulators(model));
    case scene::Estimator::analog:
      return Parts::analog_simulator(model);
    case scene::Estimator::automatic:  // left open: as forward
    case scene::Estimator::forward:
      break;
  }
  return Parts::forward_simulator(model);
}

}  // namespace

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
  if (!lanes) return make<Scalar>(model);
#if defined(PHOTIC_ISA_AVX512)
  if (lanes == Isa::avx512) return make<Lanes<Isa::avx512>>(model);
#endif
#if defined(PHOTIC_ISA_AVX2)
  if (lanes == Isa::avx2) return make<Lanes<Isa::avx2>>(model);
#endif
  return make<Lanes<Isa::baseline>>(model);
}

}  // namespace photic::schedule
