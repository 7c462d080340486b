// Compiled once for each instruction set, as PHOTIC_ISA (cmake/photic.cmake).
#include "core/pack.hpp"
#include "engine/lanes.hpp"
#include "engine/pool.hpp"

namespace photic::engine {
namespace {

using Lanes = Pack<float, native::float_lanes>;

class LaneSimulator final : public Simulator {
 public:
  explicit LaneSimulator(const Problem& problem)
      : world_(make_world<Lanes>(problem.scene, problem.medium, problem.gates)) {}

  void simulate(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally) const override {
    Pool<Lanes>(world_).run(first, count, tally, [](const auto&...) {});
  }

 private:
  World<Lanes> world_;
};

}  // namespace

namespace PHOTIC_ISA {
std::unique_ptr<Simulator> make_lanes(const Problem& problem);
std::unique_ptr<Simulator> make_lanes(const Problem& problem) {
  return std::make_unique<LaneSimulator>(problem);
}
}  // namespace PHOTIC_ISA

}  // namespace photic::engine
