#include "session/progress_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "io/table_parts.hpp"

namespace photic::session {
namespace {

constexpr int longest_bar = 20;
constexpr int shortest_bar = 8;

int digits(std::size_t number) { return static_cast<int>(fmt::format("{}", number).size()); }

double share(double part, double whole) { return whole > 0 ? std::min(1.0, part / whole) : 0.0; }

double photons_per_second(const run::Progress& p) {
  return p.elapsed_s > 0 ? static_cast<double>(p.photons - p.photons_before) / p.elapsed_s : 0.0;
}

/// The progress towards the nearest limit; none when only the target can end the run.
std::optional<double> share_of_limits(const run::Progress& p) {
  std::optional<double> out;
  if (p.photons_asked)
    out = share(static_cast<double>(p.photons), static_cast<double>(*p.photons_asked));
  if (p.max_time_s) out = std::max(out.value_or(0.0), share(p.elapsed_s, *p.max_time_s));
  return out;
}

/// Photons until the worst gate meets the target, if its error falls as the root of their number.
double photons_to_target(const run::Progress& p) {
  const double ratio = p.worst_error / *p.target;
  return static_cast<double>(p.photons) * std::max(0.0, ratio * ratio - 1);
}

/// Until the run is likely to end; none as long as nobody knows.
std::optional<double> seconds_left(const run::Progress& p) {
  std::optional<double> out;
  const auto consider = [&out](double left) { out = std::min(out.value_or(left), left); };
  const double pace = photons_per_second(p);
  if (p.photons_asked && pace > 0)
    consider(static_cast<double>(*p.photons_asked - p.photons) / pace);
  if (p.max_time_s) consider(std::max(0.0, *p.max_time_s - p.elapsed_s));
  if (p.target && pace > 0 && std::isfinite(p.worst_error)) consider(photons_to_target(p) / pace);
  return out;
}

std::string time_left(std::optional<double> seconds) {
  if (!seconds) return "";
  if (*seconds < 100) return fmt::format("{:.0f} s left", *seconds);
  if (*seconds < 6000) return fmt::format("{:.0f} min left", *seconds / 60);
  if (*seconds < 360000) return fmt::format("{:.1f} h left", *seconds / 3600);
  return *seconds < 864e5 ? fmt::format("{:.0f} d left", *seconds / 86400) : "years left";
}

std::string percent(double share) {
  if (!std::isfinite(share)) return "?";
  if (share >= 9.995) return ">999 %";
  return share < 0.01 ? fmt::format("{:.2g} %", 100 * share)
                      : fmt::format("{:.{}f} %", 100 * share, share < 0.0995 ? 1 : 0);
}

/// "worst gate 12 % (target 2.0 %)"
std::string worst(const run::Progress& p) {
  return fmt::format("worst gate {}{}", percent(p.worst_error),
                     p.target ? fmt::format(" (target {})", percent(*p.target)) : "");
}

std::string bar(double done, int room) {
  const int filled = static_cast<int>(std::lround(done * room));
  return fmt::format("[{:#<{}}{:<{}}] ", "", filled, "", room - filled);
}

}  // namespace

std::string progress_line(const run::Progress& p, int width) {
  if (p.phase == run::Phase::preparing) return "preparing the scene";
  if (p.phase == run::Phase::choosing)
    return fmt::format("comparing estimators: {} of {} pilot runs", p.pilots_done, p.pilots);
  const double done = share_of_limits(p).value_or(
      share(static_cast<double>(p.gates_converged), static_cast<double>(p.gates)));
  // Fields keep their widths, so that they stand still; the first are the last to go.
  const std::vector<std::string> fields{
      fmt::format("{:3.0f} %", std::floor(100 * done)),
      fmt::format("  {:>11}", time_left(seconds_left(p))),
      fmt::format("  {:<{}}", worst(p), p.target ? 33 : 17),
      fmt::format("  {}/{} gates", fmt::format("{:>{}}", p.gates_converged, digits(p.gates)),
                  p.gates),
      fmt::format("  {:>6}/s", io::with_prefix(photons_per_second(p))),
      fmt::format("  {:>6} photons", io::with_prefix(static_cast<double>(p.photons)))};
  std::string text;
  for (const std::string& field : fields)
    if (static_cast<int>(text.size() + field.size()) <= width) text += field;
  const int room = std::min(width - static_cast<int>(text.size()) - 3, longest_bar);
  return room < shortest_bar ? text : bar(done, room) + text;
}

}  // namespace photic::session
