// Work that is no longer wanted: those who do it look at a std::stop_token now and then.
#pragma once

#include <exception>
#include <stop_token>

namespace photic {

/// Thrown where work is broken off. What it was to make is not there.
struct Stopped : std::exception {
  [[nodiscard]] const char* what() const noexcept override { return "stopped"; }
};

[[noreturn]] void throw_stopped();

/// Throws Stopped if the work has been asked to stop.
inline void break_off_if(const std::stop_token& stop) {
  if (stop.stop_requested()) [[unlikely]]
    throw_stopped();
}

/// Something that is called now and then as light is followed, and breaks that off.
class BreakOff {
 public:
  explicit BreakOff(const std::stop_token& stop) : stop_(stop) {}
  void operator()(const auto&...) const { break_off_if(stop_); }

 private:
  const std::stop_token& stop_;
};

}  // namespace photic
