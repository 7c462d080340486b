#include "session/lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "session/checkpoint.hpp"

namespace photic::session {
namespace {

namespace fs = std::filesystem;

/// ".my.lock" beside my.nc, my.csv and my.checkpoint.nc; links are followed.
std::string lock_path(const std::string& result) {
  const fs::path name(without_checkpoint(io::behind_links(result)));
  return (name.parent_path() / fmt::format(".{}.lock", name.stem().string())).string();
}

/// A file that another user left can at least be locked.
int open_lock(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  return file >= 0 ? file : ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
}

/// Returns whether the path still leads to the open file: the process that held it may have removed
/// it.
bool is_there(int file, const std::string& path) {
  struct stat opened {
  }, found{};
  return ::fstat(file, &opened) == 0 && ::stat(path.c_str(), &found) == 0 &&
         opened.st_dev == found.st_dev && opened.st_ino == found.st_ino;
}

/// The name of this process.
std::string signature() {
  std::array<char, 256> host{};
  if (::gethostname(host.data(), host.size() - 1) != 0) host.fill('\0');
  return fmt::format("process {} on {}", ::getpid(), host.data());
}

void sign(int file) {
  const std::string text = signature();
  // On a full disk the lock holds without its owner's name.
  static_cast<void>(::ftruncate(file, 0) == 0 && ::pwrite(file, text.data(), text.size(), 0) >= 0);
}

std::string owner(int file) {
  std::array<char, 400> text{};
  const ssize_t length = ::pread(file, text.data(), text.size(), 0);
  return length > 0 ? std::string(text.data(), static_cast<std::size_t>(length))
                    : "another process";
}

[[noreturn]] void refuse_second(int file, const std::string& result, const Words& words) {
  const std::string who = owner(file);
  ::close(file);
  throw UsageError(fmt::format(
      "{}: {} (wait for its end, or choose another name with {})", result,
      who == signature() ? "a run of this process writes to it" : who + " is at work on it",
      words.output));
}

}  // namespace

Lock::Lock(const std::string& result, const FrontEnd& front_end) : path_(lock_path(result)) {
  while (file_ < 0) {
    const int file = open_lock(path_);
    if (file >= 0 && ::flock(file, LOCK_EX | LOCK_NB) == 0) {
      if (is_there(file, path_))
        file_ = file;
      else
        ::close(file);
      continue;
    }
    const int why = errno;
    if (file >= 0 && why == EWOULDBLOCK) refuse_second(file, result, front_end.words);
    if (file >= 0) ::close(file);
    front_end.report(fmt::format("{}: cannot be locked: {} (let no other run write it)", result,
                                 std::strerror(why)));
    return;
  }
  sign(file_);
}

Lock::~Lock() {
  if (file_ < 0) return;
  ::unlink(path_.c_str());  // while it is held: whoever opened it looks again
  ::close(file_);
}

}  // namespace photic::session
