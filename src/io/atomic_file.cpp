#include "io/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "core/error.hpp"

namespace photic::io {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
  throw EnvironmentError(fmt::format("{}: cannot write the file: {}", path, reason));
}
[[noreturn]] void fail_with_errno(const std::string& path) {
  fail(path, std::generic_category().message(errno));
}

/// The regular file that `path` stands for, whether it is there already or not.
fs::path target_of(const std::string& path) {
  std::error_code error;
  // A result may be a link to another disk: replace what it points to, not the link.
  fs::path target = behind_links(path);
  const fs::file_status status = fs::status(target, error);
  if (fs::is_directory(status)) fail(path, "it is a directory");
  // A rename would put a file in the place of a device such as /dev/null.
  if (fs::exists(status) && !fs::is_regular_file(status)) fail(path, "it is not a regular file");
  // A rename asks only the folder for permission; someone may have protected this very file.
  if (fs::exists(status) && ::faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0)
    fail_with_errno(path);
  return target;
}

/// A file beside its target that is removed unless it takes the target's place.
class Temporary {
 public:
  explicit Temporary(const std::string& path) : path_(path), target_(target_of(path)) {
    const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
    if (!fs::exists(folder))
      fail(path_, fmt::format("the folder {} does not exist", folder.native()));
    for (int attempt = 0; file_ < 0; ++attempt) {
      name_ = folder / fmt::format(".photic-{}-{}.part", ::getpid(), attempt);
      file_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (file_ < 0 && errno != EEXIST) fail_with_errno(path_);
    }
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    if (file_ >= 0) ::close(file_);
    if (!renamed_) ::unlink(name_.c_str());
  }

  void write(std::string_view content) const {
    while (!content.empty()) {
      const ssize_t written = ::write(file_, content.data(), content.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail_with_errno(path_);
      content.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  void take_place(const std::string& keep_as) {
    // Without it a power cut after the rename could leave an empty file instead of the old one.
    if (::fsync(file_) != 0) fail_with_errno(path_);
    const int status = ::close(file_);
    file_ = -1;
    if (status != 0) fail_with_errno(path_);
    if (!keep_as.empty()) keep_target(target_.parent_path() / fs::path(keep_as).filename());
    if (std::rename(name_.c_str(), target_.c_str()) != 0) fail_with_errno(path_);
    renamed_ = true;
  }

 private:
  /// By a second name, so that its own is never without a file; where files have one name only, by
  /// another one.
  void keep_target(const fs::path& kept) const {
    if (::access(target_.c_str(), F_OK) != 0) return;
    const std::string second = name_.native() + ".old";
    const bool linked = ::link(target_.c_str(), second.c_str()) == 0;
    if (std::rename(linked ? second.c_str() : target_.c_str(), kept.c_str()) != 0) {
      const int why = errno;
      if (linked) ::unlink(second.c_str());
      errno = why;
      fail_with_errno(path_);
    }
    if (linked) ::unlink(second.c_str());  // there if it was kept under that name already
  }

  std::string path_;  ///< as the user wrote it, for messages
  fs::path target_, name_;
  int file_ = -1;
  bool renamed_ = false;
};

}  // namespace

void write_atomically(const std::string& path, std::string_view content,
                      const std::string& keep_as) {
  Temporary temporary(path);
  temporary.write(content);
  temporary.take_place(keep_as);
}

std::string behind_links(const std::string& path) {
  constexpr int most = 40;  // as Linux has it
  fs::path target = path;
  std::error_code error;
  for (int links = 0; fs::is_symlink(target, error); ++links) {
    if (links == most) fail(path, "its links lead in a circle");
    const fs::path next = fs::read_symlink(target, error);
    if (error) fail(path, error.message());
    target = target.parent_path() / next;  // next alone, if it begins at the root
  }
  return target.string();
}

void check_writable(const std::string& path) { Temporary temporary(path); }

}  // namespace photic::io
