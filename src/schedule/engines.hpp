// The engines: the same physics by one photon at a time in double, the scalar engine, or by many in
// float, the lanes.
//
// Each is compiled once for each instruction set of x86 that is worth it; which one runs is chosen
// when the program does.
#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "core/isa.hpp"
#include "estimator/model.hpp"
#include "schedule/simulator.hpp"

namespace photic::schedule {

/// A result's name of its engine: "scalar", or "lanes (avx2)".
std::string engine_name(const std::optional<Isa>& lanes);
/// The instruction set in such a name; none for the scalar engine.
std::optional<Isa> isa_of_engine(std::string_view engine);

/// A model in lanes of an instruction set, which the processor must have, or by the scalar engine,
/// whose bits are the same by any. The model must outlive the simulator.
std::unique_ptr<Simulator> make_simulator(const estimator::Model& model,
                                          const std::optional<Isa>& lanes,
                                          const std::stop_token& stop = {});

}  // namespace photic::schedule
