// Threads that write results and read them at once, each its own files or all the same one.
#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "io/netcdf.hpp"
#include "unit/io/sample_result.hpp"
#include "unit/io/temporary_folder.hpp"

namespace photic::io {
namespace {

// Seen red: without the lock of files that are made. Without that of files that are read 1600 reads
// went well beside them.
TEST(NetcdfOfThreads, IsThatOfOne) {
  constexpr int threads = 4, rounds = 4, reads = 100;
  const test::TemporaryFolder folder;
  const tally::Result result = test::sample_result();
  const std::string shared = folder.file("shared.nc");
  write_netcdf(result, shared, {"then: photic run"});
  std::atomic<int> good = 0;
  std::vector<std::thread> all;
  for (int i = 0; i < threads; ++i)
    all.emplace_back([&, own = folder.file(std::to_string(i) + ".nc")] {
      for (int round = 0; round < rounds; ++round) try {
          write_netcdf(result, own, {"then: photic run"});
          for (int read = 0; read < reads; ++read)
            good += read_run(shared).photons == result.photons ? 1 : 0;
          good += read_state(own, test::sample_shape()) == *result.state ? 1 : 0;
        } catch (const std::exception& error) {
          ADD_FAILURE() << error.what();
        }
    });
  for (std::thread& thread : all) thread.join();
  EXPECT_EQ(good, (reads + 1) * threads * rounds);
}

}  // namespace
}  // namespace photic::io
