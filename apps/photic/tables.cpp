#include "photic/tables.hpp"

#include "estimator/model.hpp"
#include "photic/context.hpp"

namespace photic::app {

const std::shared_ptr<const optics::Library>& tables() { return context().library; }

scene::Check optics_check() {
  return [](const scene::Scene& scene, scene::Findings& findings, scene::Asked asked) {
    estimator::optics_check(tables())(scene, findings, asked);
  };
}

}  // namespace photic::app
