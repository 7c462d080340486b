// Numbers of the flags of a run, checked and turned into the values of a scene file.
// Each throws std::invalid_argument with the reason and what to write instead.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace photic::session {

/// "10000000" or "1e7" -> "10000000": a whole number of at least 1.
std::string photons_value(const std::string& text);

/// "1%" or "0.01" -> "0.01": above 0, below 1.
std::string share_value(const std::string& text);

/// "60s", "1.5min", "2h" -> seconds: above 0.
double seconds(const std::string& text);
std::string seconds_value(const std::string& text);

/// The time of a comparison, read as by seconds(): from 1 s to a day.
double bench_seconds(const std::string& text);

/// A whole number from 0.
std::string seed_value(const std::string& text);

/// "355,532,685" or "400:700:10", or both in one list: ascending wavelengths in nm, at most
/// max_wavelengths.
inline constexpr std::size_t max_wavelengths = 10000;
std::vector<double> wavelengths_nm(const std::string& text);

/// "532" or "532.0": a wavelength in nm, above 0.
std::string wavelength_value(const std::string& text);

}  // namespace photic::session
