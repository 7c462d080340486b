#include "photic/terminal.hpp"

#include <fmt/color.h>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>

namespace photic::app {
namespace {

int descriptor(Stream stream) { return stream == Stream::out ? STDOUT_FILENO : STDERR_FILENO; }

bool colours(Stream stream) {
  const char* refused = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  return is_terminal(stream) && (refused == nullptr || *refused == '\0') &&
         (terminal == nullptr || std::string_view(terminal) != "dumb");
}

fmt::text_style style(Colour colour) {
  switch (colour) {
    case Colour::bold:
      return fmt::emphasis::bold;
    case Colour::red:
      return fmt::emphasis::bold | fmt::fg(fmt::terminal_color::red);
    case Colour::yellow:
      return fmt::fg(fmt::terminal_color::yellow);
    case Colour::cyan:
      return fmt::fg(fmt::terminal_color::cyan);
  }
  return {};
}

}  // namespace

bool is_terminal(Stream stream) { return isatty(descriptor(stream)) == 1; }

int columns(Stream stream, int otherwise) {
  winsize size{};
  if (!is_terminal(stream)) return otherwise;
  return ioctl(descriptor(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

std::string painted(std::string_view text, Colour colour, Stream stream) {
  if (text.empty() || !colours(stream)) return std::string(text);
  const std::size_t end = text.ends_with('\n') ? text.size() - 1 : text.size();
  return fmt::format(style(colour), "{}", text.substr(0, end)).append(text.substr(end));
}

}  // namespace photic::app
