// The echo of a result as rows, one for each telescope, channel and gate: what CSV, JSON and the
// terminal's tables have in common.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "tally/result.hpp"

namespace photic::io {

struct EchoRow {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::size_t telescope{}, channel{}, gate{};  ///< indices, from 0
  double time_start_ns{}, time_end_ns{};
  double depth_m{};          ///< centre of the gate; the range if Result::gate_depth_is_range; NaN
                             ///< where the telescope has none
  double echo{};             ///< expected photons detected per photon emitted
  double standard_error{};   ///< of the echo
  double difference = none;  ///< of an environment's echo to the scene's
  double difference_standard_error = none;
  double sensitivity = none;  ///< derivative of the echo with respect to a parameter
  double sensitivity_standard_error = none;
  double logarithmic_sensitivity = none;  ///< NaN where the echo is 0, too
  double logarithmic_sensitivity_standard_error = none;
  double relative_error{};  ///< standard_error / echo; NaN where the echo is not above 0
  std::int32_t flags{};     ///< Result::convergence_flags

  [[nodiscard]] bool converged() const { return flags == 0; }
};

/// All rows, the gates of a channel after each other, the channels of a telescope after each other.
std::vector<EchoRow> echo_rows(const tally::Result& result);

/// The same of an environment, by its index.
std::vector<EchoRow> environment_rows(const tally::Result& result, std::size_t environment);

/// The scene's echo with its derivatives with respect to a parameter, by its index; the flags are
/// those of the derivatives.
std::vector<EchoRow> sensitivity_rows(const tally::Result& result, std::size_t parameter);

/// "elastic 400000, raman 800000": channels whose echoes are means over fewer photons than were
/// emitted, since they rested; empty if none did.
std::string rested_channels(const tally::Result& result);

/// The names of the flags set, lowest bit first.
std::vector<std::string_view> flag_names(std::int32_t flags);

}  // namespace photic::io
