#include "schedule/engines.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "schedule/engine_parts.hpp"

namespace photic::schedule {
namespace {

template <class Engine>
std::unique_ptr<SetSimulator> make(const estimator::HistorySet& set) {
  using Parts = EngineParts<Engine>;
  using enum estimator::HistorySet::Kind;
  switch (set.kind) {
    case walks:
      return Parts::walks_simulator(set);
    case surface_echo:
      return Parts::surface_echo_simulator(set);
    case analog:
      return Parts::analog_simulator(set);
    case histories:
      break;
  }
  return Parts::histories_simulator(set);
}

Simulator::MakeSet parts_of(const std::optional<Isa>& lanes) {
  if (!lanes) return make<Scalar>;
#if defined(PHOTIC_ISA_AVX512)
  if (lanes == Isa::avx512) return make<Lanes<Isa::avx512>>;
#endif
#if defined(PHOTIC_ISA_AVX2)
  if (lanes == Isa::avx2) return make<Lanes<Isa::avx2>>;
#endif
  return make<Lanes<Isa::baseline>>;
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
                                          const std::optional<Isa>& lanes,
                                          const std::stop_token& stop) {
  expect(!lanes || runs_here(*lanes), "lanes are made of instructions that the processor has");
  return std::make_unique<Simulator>(estimator::make_plan(model, stop), parts_of(lanes));
}

}  // namespace photic::schedule
