#include "io/netcdf_probe.hpp"

#include <fcntl.h>
#include <netcdf.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <exception>
#include <initializer_list>
#include <limits>
#include <vector>

#include "core/error.hpp"
#include "io/netcdf_lock.hpp"
#include "io/netcdf_reader.hpp"

namespace photic::io {
namespace {

/// The first letter of what the process reports; the words of a failure follow.
constexpr char good = 'g', bad_input = 'i', bad_environment = 'e';

/// Reads a file as those who open it will, and refuses it where that fails.
class Reading {
 public:
  Reading(const std::string& path, bool groups) : path_(path), groups_(groups), reader_(path) {
    read_group(reader_.id());
  }

 private:
  void check(int status) const {
    if (status == NC_NOERR) return;
    const std::string reason = std::string("a damaged netCDF file: ") + nc_strerror(status);
    throw InputError({{.file = path_, .reason = reason, .suggestion = ""}});
  }

  void read_group(int group) const {
    int variables = 0, attributes = 0, groups = 0;
    check(nc_inq(group, nullptr, &variables, &attributes, nullptr));
    read_attributes(group, NC_GLOBAL, attributes);
    for (int i = 0; i < variables; ++i) read_variable(group, i);
    if (!groups_) return;
    check(nc_inq_grps(group, &groups, nullptr));
    std::vector<int> inner(static_cast<std::size_t>(groups));
    check(nc_inq_grps(group, nullptr, inner.data()));
    for (const int one : inner) read_group(one);
  }

  /// `get` puts the values into memory.
  template <class Get>
  void read_values(int group, nc_type type, std::size_t count, const Get& get) const {
    constexpr std::size_t most = std::size_t{1} << 30U;  // larger ones are left alone
    std::size_t size = 0;
    check(nc_inq_type(group, type, nullptr, &size));
    if (size == 0 || count == 0) return;
    if (count > most / size) return expect_room_for(count, size);
    std::vector<char> values(size * count);
    check(get(values.data()));
    if (type == NC_STRING) check(nc_free_string(count, reinterpret_cast<char**>(values.data())));
  }

  /// No compression of netCDF's makes more than a thousand bytes of one.
  void expect_room_for(std::size_t count, std::size_t size) const {
    constexpr std::size_t best_compression = 1100;
    if (count / best_compression > reader_.size() / size) check(NC_EDIMSIZE);
  }

  void read_attributes(int group, int variable, int count) const {
    for (int i = 0; i < count; ++i) {
      std::array<char, NC_MAX_NAME + 1> name{};
      nc_type type = NC_NAT;
      std::size_t length = 0;
      check(nc_inq_attname(group, variable, i, name.data()));
      check(nc_inq_att(group, variable, name.data(), &type, &length));
      read_values(group, type, length,
                  [&](void* to) { return nc_get_att(group, variable, name.data(), to); });
    }
  }

  void read_variable(int group, int variable) const {
    std::array<int, NC_MAX_VAR_DIMS> dimensions{};
    int rank = 0, attributes = 0;
    nc_type type = NC_NAT;
    check(nc_inq_var(group, variable, nullptr, &type, &rank, dimensions.data(), &attributes));
    read_attributes(group, variable, attributes);
    std::size_t count = 1;
    for (std::size_t i = 0; i < static_cast<std::size_t>(rank); ++i) {
      std::size_t length = 0;
      check(nc_inq_dimlen(group, dimensions[i], &length));
      if (length != 0 && count > std::numeric_limits<std::size_t>::max() / length)
        check(NC_EDIMSIZE);
      count *= length;
    }
    read_values(group, type, count, [&](void* to) { return nc_get_var(group, variable, to); });
  }

  const std::string& path_;
  const bool groups_;
  NetcdfReader reader_;
};

std::string outcome_of(const std::string& path, bool groups) {
  try {
    { const Reading all(path, groups); }  // closed, which may crash, too
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

[[noreturn]] void report_outcome(const std::string& path, bool groups, int pipe) {
  crash_silently();
  NetcdfLock::renew();
  const std::string outcome = outcome_of(path, groups);
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

/// The report of a process of its own; empty if it crashed. None can be forked: as a good file.
std::string outcome_elsewhere(const std::string& path, bool groups) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return std::string(1, good);
  const NetcdfLock lock;  // so that no other thread is in HDF5
  const pid_t child = ::fork();
  if (child == 0) report_outcome(path, groups, ends[1]);
  ::close(ends[1]);
  std::string out = child < 0 ? std::string(1, good) : read_all(ends[0]);
  ::close(ends[0]);
  while (child > 0 && ::waitpid(child, nullptr, 0) < 0 && errno == EINTR) continue;
  return out;
}

}  // namespace

void expect_netcdf(const std::string& path, bool groups) {
  const std::string outcome = outcome_elsewhere(path, groups);
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
