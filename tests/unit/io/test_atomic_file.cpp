#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <functional>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/csv.hpp"
#include "io/netcdf.hpp"
#include "unit/io/sample_result.hpp"
#include "unit/io/temporary_folder.hpp"

namespace photic::io {
namespace {

using test::read_file;
using test::TemporaryFolder;
using test::write_file;
using Names = std::vector<std::string>;

std::string error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const EnvironmentError& error) {
    return error.what();
  }
  return "no error";
}

/// A disk that is full after `bytes`: a limit on the size of files fails the write as ENOSPC would.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    ::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() { ::setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

/// Folder permissions do not bind root: be someone else for a while.
class NotRoot {
 public:
  NotRoot() : before_(::geteuid()) {
    if (before_ == 0 && ::seteuid(65534) != 0)
      throw std::runtime_error("cannot be someone else than root");
  }
  ~NotRoot() {
    if (::seteuid(before_) != 0) std::abort();
  }

 private:
  uid_t before_;
};

TEST(AtomicFile, WritesAndReplaces) {
  const TemporaryFolder folder;
  const std::string path = folder.file("out.txt");
  write_atomically(path, "first");
  EXPECT_EQ(read_file(path), "first");
  write_atomically(path, std::string("sec\0nd", 6));
  EXPECT_EQ(read_file(path), std::string("sec\0nd", 6));
  EXPECT_EQ(folder.files(), Names{"out.txt"});
}

TEST(AtomicFile, HasThePermissionsOfAnyNewFile) {
  const TemporaryFolder folder;
  const mode_t before = ::umask(027);
  write_atomically(folder.file("out.txt"), "text");
  ::umask(before);
  struct stat status {};
  ASSERT_EQ(::stat(folder.file("out.txt").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST(AtomicFile, FollowsALinkAndKeepsIt) {
  const TemporaryFolder folder, elsewhere;
  write_file(elsewhere.file("real.txt"), "old");
  std::filesystem::create_symlink(elsewhere.file("real.txt"), folder.file("link.txt"));
  write_atomically(folder.file("link.txt"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link.txt")));
  EXPECT_EQ(read_file(elsewhere.file("real.txt")), "new");
}

// Seen red: with the link replaced where its file is not there yet.
TEST(AtomicFile, FollowsALinkToAFileThatIsToBe) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("link2.txt", folder.file("link.txt"));
  std::filesystem::create_symlink("real.txt", folder.file("link2.txt"));
  EXPECT_EQ(behind_links(folder.file("link.txt")), folder.file("real.txt"));
  write_atomically(folder.file("link.txt"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link.txt")));
  EXPECT_EQ(read_file(folder.file("real.txt")), "new");
  std::filesystem::create_symlink("circle.txt", folder.file("circle.txt"));
  EXPECT_TRUE(error_of([&] {
                write_atomically(folder.file("circle.txt"), "text");
              }).ends_with("its links lead in a circle"));
}

// Seen red: with the older file's name taken from it before the new one is whole.
TEST(AtomicFile, KeepsTheOlderFileOnceUnderAnotherName) {
  const TemporaryFolder folder;
  const std::string path = folder.file("out.txt");
  write_atomically(path, "first", "out.previous.txt");
  EXPECT_EQ(folder.files(), Names{"out.txt"});
  write_atomically(path, "second", "out.previous.txt");
  write_atomically(path, "third", "out.previous.txt");
  EXPECT_EQ(folder.files(), (Names{"out.previous.txt", "out.txt"}));
  EXPECT_EQ(read_file(folder.file("out.previous.txt")), "second");
  {
    const FullDisk disk(1000);
    EXPECT_NE(error_of([&] { write_atomically(path, std::string(9999, 'x'), "out.previous.txt"); }),
              "no error");
  }
  EXPECT_EQ(read_file(path), "third");
  EXPECT_EQ(read_file(folder.file("out.previous.txt")), "second");
  // Where a power cut came between the two: both names stand for one file.
  std::filesystem::remove(folder.file("out.previous.txt"));
  std::filesystem::create_hard_link(path, folder.file("out.previous.txt"));
  write_atomically(path, "fourth", "out.previous.txt");
  EXPECT_EQ(read_file(folder.file("out.previous.txt")), "third");
  EXPECT_EQ(folder.files(), (Names{"out.previous.txt", "out.txt"}));
}

TEST(AtomicFile, MissingFolder) {
  const TemporaryFolder folder;
  const std::string path = folder.file("none/out.nc");
  EXPECT_EQ(
      error_of([&] { write_atomically(path, "text"); }),
      path + ": cannot write the file: the folder " + folder.file("none") + " does not exist");
  EXPECT_EQ(error_of([&] { check_writable(path); }),
            error_of([&] { write_atomically(path, "text"); }));
}

TEST(AtomicFile, Directory) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("out.nc"));
  EXPECT_EQ(error_of([&] { write_atomically(folder.file("out.nc"), "text"); }),
            folder.file("out.nc") + ": cannot write the file: it is a directory");
}

TEST(AtomicFile, ParentIsAFile) {
  const TemporaryFolder folder;
  write_file(folder.file("file"), "");
  EXPECT_TRUE(error_of([&] {
                write_atomically(folder.file("file/out.nc"), "text");
              }).ends_with("Not a directory"));
}

// Seen red: without the check the rename would replace the fifo (as root: /dev/null) by a file.
TEST(AtomicFile, DevicesAreNotReplaced) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo(folder.file("fifo").c_str(), 0600), 0);
  EXPECT_TRUE(error_of([&] {
                write_atomically(folder.file("fifo"), "text");
              }).ends_with("it is not a regular file"));
  EXPECT_TRUE(std::filesystem::is_fifo(folder.file("fifo")));
}

TEST(AtomicFile, FolderWithoutPermission) {
  const TemporaryFolder folder;
  write_file(folder.file("out.nc"), "old");
  std::filesystem::permissions(folder.file("out.nc"), std::filesystem::perms{0666});
  std::filesystem::permissions(folder.file("."), std::filesystem::perms{0555});
  {
    const NotRoot someone;
    for (const auto& action :
         {std::function<void()>([&] { write_atomically(folder.file("out.nc"), "new"); }),
          std::function<void()>([&] { check_writable(folder.file("out.nc")); })})
      EXPECT_EQ(error_of(action),
                folder.file("out.nc") + ": cannot write the file: Permission denied");
  }
  std::filesystem::permissions(folder.file("."), std::filesystem::perms{0755});
  EXPECT_EQ(read_file(folder.file("out.nc")), "old");
  EXPECT_EQ(folder.files(), Names{"out.nc"});
}

TEST(AtomicFile, ProtectedFile) {
  const TemporaryFolder folder;
  write_file(folder.file("out.nc"), "old");
  std::filesystem::permissions(folder.file("out.nc"), std::filesystem::perms{0444});
  std::filesystem::permissions(folder.file("."), std::filesystem::perms{0777});
  {
    const NotRoot someone;
    EXPECT_TRUE(error_of([&] {
                  write_atomically(folder.file("out.nc"), "new");
                }).ends_with("Permission denied"));
  }
  EXPECT_EQ(read_file(folder.file("out.nc")), "old");
}

TEST(AtomicFile, FullDiskLeavesTheOldFile) {
  const TemporaryFolder folder;
  const std::string path = folder.file("out.txt");
  write_file(path, "old");
  std::string error;
  {
    const FullDisk disk(1000);
    error = error_of([&] { write_atomically(path, std::string(100'000, 'x')); });
  }
  EXPECT_EQ(error, path + ": cannot write the file: File too large");
  EXPECT_EQ(read_file(path), "old");
  EXPECT_EQ(folder.files(), Names{"out.txt"});
}

// Seen red: writing straight to `path` leaves a torn result; not unlinking leaves a second file.
TEST(AtomicFile, FailedResultsLeaveTheOldOnes) {
  const TemporaryFolder folder;
  const tally::Result result = test::sample_result();
  for (const std::string& path : {folder.file("out.nc"), folder.file("out.csv")}) {
    write_file(path, "old");
    const auto write = [&] {
      if (path.ends_with(".csv"))
        write_csv(result, path);
      else
        write_netcdf(result, path, {"test"});
    };
    {
      const FullDisk disk(4096);
      EXPECT_EQ(error_of(write), path + ": cannot write the file: File too large");
    }
    EXPECT_EQ(read_file(path), "old");
    EXPECT_EQ(error_of(write), "no error");
    EXPECT_NE(read_file(path), "old");
  }
  EXPECT_EQ(folder.files(), (Names{"out.csv", "out.nc"}));
}

TEST(AtomicFile, CheckLeavesNothing) {
  const TemporaryFolder folder;
  check_writable(folder.file("out.nc"));
  EXPECT_EQ(folder.files(), Names{});
  write_file(folder.file("out.nc"), "old");
  check_writable(folder.file("out.nc"));
  EXPECT_EQ(read_file(folder.file("out.nc")), "old");
}

}  // namespace
}  // namespace photic::io
