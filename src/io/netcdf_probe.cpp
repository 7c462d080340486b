#include "io/netcdf_probe.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <exception>
#include <initializer_list>

#include "core/error.hpp"
#include "io/netcdf_lock.hpp"
#include "io/netcdf_reader.hpp"

namespace photic::io {
namespace {

/// The first letter of what the process reports; the words of a failure follow.
constexpr char good = 'g', bad_input = 'i', bad_environment = 'e';

std::string outcome_of(const std::string& path) {
  try {
    const NetcdfReader reader(path);
    return std::string(1, good);
  } catch (const InputError& error) {
    return bad_input + error.diagnostics().front().reason;
  } catch (const std::exception& error) {
    return bad_environment + std::string(error.what());
  }
}

/// A crash leaves no words on the terminal and no core.
void crash_silently() {
  const rlimit none{0, 0};
  static_cast<void>(::setrlimit(RLIMIT_CORE, &none));
  for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL})
    static_cast<void>(std::signal(signal, SIG_DFL));
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) static_cast<void>(::dup2(nowhere, STDERR_FILENO));
}

[[noreturn]] void report_outcome(const std::string& path, int pipe) {
  crash_silently();
  NetcdfLock::renew();
  const std::string outcome = outcome_of(path);
  static_cast<void>(::write(pipe, outcome.data(), outcome.size()) >= 0);
  ::_exit(0);
}

std::string read_all(int pipe) {
  std::string out;
  std::array<char, 512> part{};
  while (true) {
    const ssize_t length = ::read(pipe, part.data(), part.size());
    if (length > 0) out.append(part.data(), static_cast<std::size_t>(length));
    if (length == 0 || (length < 0 && errno != EINTR)) return out;
  }
}

/// What a process of its own reports; nothing if it crashed. None can be forked: as a good file.
std::string outcome_elsewhere(const std::string& path) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return std::string(1, good);
  const NetcdfLock lock;  // so that no other thread is in HDF5
  const pid_t child = ::fork();
  if (child == 0) report_outcome(path, ends[1]);
  ::close(ends[1]);
  const std::string out = child < 0 ? std::string(1, good) : read_all(ends[0]);
  ::close(ends[0]);
  while (child > 0 && ::waitpid(child, nullptr, 0) < 0 && errno == EINTR) continue;
  return out;
}

}  // namespace

void expect_netcdf(const std::string& path) {
  const std::string outcome = outcome_elsewhere(path);
  const auto refuse = [&](const std::string& reason) {
    throw InputError({{.file = path,
                       .reason = reason,
                       .suggestion = "a result is what `photic run SCENE -o out.nc` writes"}});
  };
  if (outcome.empty()) refuse("a damaged netCDF file: HDF5 crashes on it");
  if (outcome[0] == bad_input) refuse(outcome.substr(1));
  if (outcome[0] == bad_environment) throw EnvironmentError(outcome.substr(1));
}

}  // namespace photic::io
