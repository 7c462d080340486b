// The phase functions of a medium that is being built.
#pragma once

#include <cstdint>

#include "medium/medium.hpp"
#include "optics/aerosols.hpp"
#include "optics/phase_table_cache.hpp"

namespace photic::medium {

/// Puts tables into a medium and numbers them; where they are left out, all are number 0.
class PhaseNumbers {
 public:
  PhaseNumbers(const optics::PhaseTableCache& tables, optics::Phases phases, Medium& medium)
      : tables_(tables), phases_(phases), medium_(medium) {}

  std::int32_t operator()(const optics::PhaseShape& shape) const {
    return phases_ == optics::Phases::left_out ? 0 : medium_.add_phase(tables_(shape));
  }

 private:
  const optics::PhaseTableCache& tables_;
  optics::Phases phases_;
  Medium& medium_;
};

}  // namespace photic::medium
