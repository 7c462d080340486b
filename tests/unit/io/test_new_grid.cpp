// A grid that nobody knows but its description: tallied, written, continued, and opened in Python.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "estimator/model.hpp"
#include "io/netcdf.hpp"
#include "schedule/engines.hpp"
#include "support/scenes.hpp"
#include "support/tables.hpp"
#include "tally/totals.hpp"
#include "unit/io/netcdf_file.hpp"
#include "unit/io/temporary_folder.hpp"

namespace photic::io {
namespace {

struct Simulated {
  estimator::Model model = [] {
    using namespace test;
    auto out = estimator::make_model(
        read(ship_instrument + channel("elastic") + channel("raman") + three_layers +
             depth_gates(10, 2) + simulation(1e4, 5, "batch_photons = 2000", "forward")),
        *test::tables());
    auto& grids = out.shape.grids;
    grids.push_back({.name = "echo_by_process_and_order",
                     .long_name = "by process and order",
                     .part = "echo of a process and an order",
                     .axes = {grids[1].axes[0], grids[0].axes[0]}});
    return out;
  }();
  std::unique_ptr<schedule::Simulator> simulator = schedule::make_simulator(model, Isa::baseline);

  void add_batch(std::uint64_t first, tally::Totals& totals) const {
    tally::BatchTally batch(model.shape, model.gates);
    simulator->simulate(first, 2000, batch, {});
    batch.photons = 2000;
    totals.merge(batch);
  }
  void write(const tally::Totals& totals, const std::string& file) const {
    tally::Result result = estimator::describe(model);
    totals.fill(result);
    result.state = totals.state();
    write_netcdf(result, file, {"test"});
  }
};

// Seen red: with the grids of the state left out; with one of its axes alone; with flags of parts
// named one by one in Python.
TEST(Grids, ANewOneIsInFilesContinuesAndOpensInPython) {
  const test::TemporaryFolder folder;
  const Simulated run;
  tally::Totals whole(run.model.shape);
  run.add_batch(0, whole);
  run.write(whole, folder.file("one.nc"));
  tally::Totals resumed(run.model.shape, read_state(folder.file("one.nc"), run.model.shape));
  for (tally::Totals* totals : {&whole, &resumed}) run.add_batch(2000, *totals);
  EXPECT_EQ(resumed.state(), whole.state());
  run.write(resumed, folder.file("two.nc"));

  const auto by_both = NetcdfFile(folder.file("two.nc")).numbers("echo_by_process_and_order");
  EXPECT_EQ(by_both.size(), run.model.shape.cells() * run.model.shape.grids.back().size());
  const std::string check =
      "import photic, sys; d = photic.open(sys.argv[1]); both = d.echo_by_process_and_order; "
      "assert float(both.sel(process='raman', order=1).sum()) > 0; "
      "assert abs(both.sum('process') - d.echo_by_order).max() < 1e-12 * d.echo_by_order.max(); "
      "assert d.echo_by_process_and_order_converged.dtype == bool";
  EXPECT_EQ(std::system(fmt::format("PYTHONPATH='{}/python' {} -c \"{}\" '{}'", PHOTIC_SOURCE_DIR,
                                    PHOTIC_PYTHON, check, folder.file("two.nc"))
                            .c_str()),
            0);
}

}  // namespace
}  // namespace photic::io
