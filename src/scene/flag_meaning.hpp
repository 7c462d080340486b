// The meaning of quality flags.
#pragma once

#include <optional>
#include <string>

namespace photic::scene {

enum class Quality {
  good,
  unchecked,  ///< or changed: neither good nor bad
  bad,        ///< or missing
  unclear     ///< not understood
};

/// The quality by the meaning that a file gives to a flag: "probably_bad_data", "not_evaluated",
/// "pass".
[[nodiscard]] Quality quality_of(const std::string& meaning);

/// The quality by a flag that a file does not explain, by Argo's table (Argo user's manual,
/// reference table 2; from memory), which QARTOD's flags 1, 2, 3, 4 and 9 agree with (IOOS manuals;
/// from memory).
[[nodiscard]] Quality quality_in_table(const std::string& flag);

}  // namespace photic::scene
