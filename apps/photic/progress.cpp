#include "photic/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "photic/output.hpp"

namespace photic::app {
namespace {

constexpr int longest_bar = 30;
constexpr const char* wipe_line = "\r\033[K";

int terminal_width() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

double share(double part, double whole) { return whole > 0 ? std::min(1.0, part / whole) : 0.0; }

double photons_per_second(const engine::Progress& p) {
  return p.elapsed_s > 0 ? static_cast<double>(p.photons - p.photons_before) / p.elapsed_s : 0.0;
}

/// How far towards the limit that is nearest; none when only the target can end the run.
std::optional<double> share_of_limits(const engine::Progress& p) {
  std::optional<double> out;
  if (p.photons_asked)
    out = share(static_cast<double>(p.photons), static_cast<double>(*p.photons_asked));
  if (p.max_time_s) out = std::max(out.value_or(0.0), share(p.elapsed_s, *p.max_time_s));
  return out;
}

/// Until the first limit is reached; none as long as nobody knows.
std::optional<double> seconds_left(const engine::Progress& p) {
  std::optional<double> out;
  if (p.photons_asked && photons_per_second(p) > 0)
    out = static_cast<double>(*p.photons_asked - p.photons) / photons_per_second(p);
  if (p.max_time_s) {
    const double left = std::max(0.0, *p.max_time_s - p.elapsed_s);
    out = std::min(out.value_or(left), left);
  }
  return out;
}

std::string time_left(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s left", seconds);
  if (seconds < 6000) return fmt::format("{:.0f} min left", seconds / 60);
  return fmt::format("{:.1f} h left", seconds / 3600);
}

}  // namespace

std::string progress_line(const engine::Progress& p, int width) {
  const auto limits = share_of_limits(p);
  const double done =
      limits.value_or(share(static_cast<double>(p.gates_converged), static_cast<double>(p.gates)));
  std::string text = fmt::format("{:3.0f} %  {:.2g} photons", std::floor(100 * done),
                                 static_cast<double>(p.photons));
  if (photons_per_second(p) > 0) text += fmt::format("  {:.2g}/s", photons_per_second(p));
  text += fmt::format("  gates converged {}/{}", p.gates_converged, p.gates);
  if (const auto left = seconds_left(p)) text += "  " + time_left(*left);
  const int room = std::clamp(width - static_cast<int>(text.size()) - 3, 0, longest_bar);
  const int filled = static_cast<int>(std::lround(done * room));
  std::string line = fmt::format("[{:#<{}}{:<{}}] {}", "", filled, "", room - filled, text);
  line.resize(std::min(line.size(), static_cast<std::size_t>(std::max(width, 0))));
  return line;
}

void ProgressBar::draw(const engine::Progress& progress) {
  // A last column left free keeps terminals from wrapping.
  print_error(wipe_line + progress_line(progress, terminal_width() - 1));
  drawn_ = true;
}

void ProgressBar::wipe() {
  if (drawn_) print_error(wipe_line);
  drawn_ = false;
}

bool has_terminal() { return isatty(STDERR_FILENO) == 1; }

}  // namespace photic::app
