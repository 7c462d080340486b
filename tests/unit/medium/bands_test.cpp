// Spectra cut into lines, filters, and the spectral_bins by which photons are shared out among
// lines.
#include "medium/bands.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <numeric>

#include "medium/filters.hpp"
#include "medium/lines.hpp"
#include "unit/medium/scenes.hpp"

namespace photic::medium {
namespace {

/// 0 at 600 nm, rising to 0.02 per nm at 700: one photon.
const optics::EmissionSpectrum ramp({600, 700}, {0, 0.02});

scene::Channel gaussian(double centre, double fwhm) {
  auto channel = test::filter(centre, fwhm);
  channel.filter = scene::FilterShape::gaussian;
  return channel;
}

std::vector<BandLine> cut(const std::vector<scene::Channel>& channels,
                          const std::vector<bool>& counts_all) {
  std::vector<std::optional<Filter>> filters;
  for (const auto& channel : channels) filters.push_back(filter_of(channel));
  return cut_into_lines(ramp, counts_all, filters);
}

double counted(const std::vector<BandLine>& lines, std::size_t channel) {
  double sum = 0;
  for (const auto& line : lines) sum += line.photons * line.counted_by[channel];
  return sum;
}

TEST(CutIntoLines, KeepsPhotonsAndTheirMeanWavelength) {
  const auto lines = cut({test::channel_of(Process::raman)}, {true});
  EXPECT_EQ(lines.size(), 20U);
  EXPECT_NEAR(counted(lines, 0), 1, 1e-12);
  double mean = 0;
  for (const auto& line : lines) mean += line.photons * line.wavelength_nm;
  EXPECT_NEAR(mean, 600 + 200.0 / 3, 1e-9);
  EXPECT_NEAR(lines[0].wavelength_nm, 600 + 10.0 / 3, 1e-9);
}

// Seen red: with all of a line's light counted where some passes.
TEST(CutIntoLines, CountsWhatFiltersLetThrough) {
  const auto top_hat = cut({test::filter(650, 3)}, {false});
  EXPECT_EQ(top_hat.size(), 1U);  // nothing else is seen
  EXPECT_NEAR(counted(top_hat, 0), 3 * 0.01, 1e-12);
  EXPECT_NEAR(top_hat[0].wavelength_nm, 650, 0.03);

  // The ramp is odd about its value at the centre: a Gaussian's area times that.
  const double area = 12 * std::sqrt(pi / (4 * std::log(2.0)));
  const auto lines = cut({gaussian(650, 12)}, {false});
  EXPECT_NEAR(counted(lines, 0), 0.01 * area, 4e-5 * area);
  for (const auto& line : lines) EXPECT_NEAR(line.wavelength_nm, 650, 24);

  const auto both = cut({test::channel_of(Process::cdom), gaussian(650, 12)}, {true, false});
  EXPECT_NEAR(counted(both, 0), 1, 1e-12);
  EXPECT_NEAR(counted(both, 1), 0.01 * area, 4e-5 * area);
}

TEST(FilterOf, HasHalfItsTransmissionAtHalfItsWidth) {
  const auto filter = filter_of(gaussian(650, 12));
  EXPECT_NEAR(filter->transmission(650), 1, 1e-15);
  EXPECT_NEAR(filter->transmission(656), 0.5, 1e-12);
  EXPECT_NEAR(filter->transmission(644), 0.5, 1e-12);
  EXPECT_EQ(filter->transmission(675), 0);
  const auto top_hat = filter_of(test::filter(650, 12));
  EXPECT_EQ(top_hat->transmission(656), 1);
  EXPECT_EQ(top_hat->transmission(656.1), 0);
  EXPECT_FALSE(filter_of(test::channel_of(Process::raman)));
}

TEST(FilterOf, ReadsAUsersTable) {
  const auto path =
      std::filesystem::path(testing::TempDir()) / (std::to_string(getpid()) + "photic_filter.csv");
  const auto with = [&](const std::string& rows) {
    std::ofstream(path) << "wavelength_nm,transmission\n" << rows;
    scene::Channel channel;
    channel.transmission =
        scene::UserTable(optics::DataTable::read(path.string()), {"wavelength_nm", "transmission"});
    return filter_of(channel);
  };
  const auto refused = [&](const std::string& rows) {
    try {
      with(rows);
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string("nothing was refused");
  };
  const auto filter = with("640,0\n650,0.8\n660,0\n");
  EXPECT_NEAR(filter->transmission(645), 0.4, 1e-15);
  EXPECT_EQ(filter->transmission(661), 0);
  EXPECT_EQ(filter->cuts_nm, (std::vector<double>{640, 650, 660}));
  EXPECT_NE(
      refused("640,0\n650,80\n").find(":3:5: a transmission is from 0 to 1 (is it in percent?)"),
      std::string::npos);
  EXPECT_NE(refused("640,0\n630,0.1\n").find(":3:1:"), std::string::npos);
  EXPECT_NE(refused("640,0.1\n").find("two rows or more"), std::string::npos);
  std::filesystem::remove(path);
}

/// Water of constituents, its light in spectra.
scene::Scene spectra_scene(std::vector<scene::Channel> channels) {
  scene::Layer layer;
  layer.name = "top";
  layer.chlorophyll_mg_m3 = 0.5;
  layer.cdom_a440_per_m = 0.05;
  auto scene = scene_of({layer}, std::move(channels));
  scene.optics.emission = scene::Emission::spectra;
  scene.source.wavelength_nm = 450;
  return scene;
}

double emitted_in(const Medium& m, Process process) {
  double sum = 0;
  for (std::size_t l = 1; l < m.line.size(); ++l)
    if (m.line[l].process == process) sum += m.conversion[l] * m.c[0];
  return sum;
}

// As many photons as in one line each.
TEST(BuildMedium, SpreadsEmittedLightOverSpectra) {
  const std::vector<scene::Channel> channels{test::channel_of(Process::raman),
                                             test::channel_of(Process::chlorophyll),
                                             test::channel_of(Process::cdom)};
  auto scene = spectra_scene(channels);
  const auto m = medium_of(scene);
  std::map<Process, int> lines;
  for (const Line& line : m.line) ++lines[line.process];
  EXPECT_GT(lines[Process::raman], 4);
  EXPECT_GT(lines[Process::chlorophyll], 15);
  EXPECT_GT(lines[Process::cdom], 50);
  scene.optics.emission = scene::Emission::lines;
  const auto one = medium_of(scene);
  EXPECT_NEAR(emitted_in(m, Process::raman) / emitted_in(one, Process::raman), 1, 2e-5);
  EXPECT_NEAR(emitted_in(m, Process::chlorophyll) / emitted_in(one, Process::chlorophyll), 1, 1e-4);
  const double a_cdom = 0.05 * std::exp(-0.017 * (450 - 440));
  EXPECT_NEAR(emitted_in(m, Process::cdom), 0.019 * a_cdom, 0.0005 * a_cdom);
  EXPECT_EQ(emitted_in(m, Process::cdom), emitted_in(one, Process::cdom));
  EXPECT_NEAR(m.absorption[0] + m.albedo[0] +
                  std::accumulate(m.conversion.begin(), m.conversion.end(), 0.0),
              1, 1e-14);
}

// CDOM's light under the Raman line is seen through a filter, and not by a channel of a process.
TEST(BuildMedium, ShowsAllProcessesThroughAFilter) {
  const auto m = medium_of(spectra_scene({gaussian(531, 10), test::channel_of(Process::raman)}));
  double cdom = 0, raman = 0;
  for (const Line& line : m.line) {
    if (line.process == Process::cdom) {
      cdom += line.photons * line.counted_by[0];
      EXPECT_EQ(line.counted_by[1], 0);
      EXPECT_NEAR(line.wavelength_nm, 531, 20);
    }
    if (line.process == Process::raman) raman += line.photons * line.counted_by[0];
  }
  EXPECT_GT(cdom, 0);
  EXPECT_GT(raman, 0);
}

// Every line has spectral_bins, as many as its share of photons and an even share come to, and what
// it emits is made up for them. Seen red: made up for as if all lines had as many.
TEST(Medium, SharesOutHuesAmongTheLinesOfABand) {
  const auto m =
      medium_of(spectra_scene({test::channel_of(Process::raman), test::channel_of(Process::cdom)}));
  const auto view = m.view();
  ASSERT_EQ(view.bands, 2);
  EXPECT_EQ(view.convertible_count[0], 2);
  std::vector<int> count(m.line.size());
  for (std::int32_t band = 0; band < 2; ++band) {
    for (std::int32_t spectral_bin = 0; spectral_bin < spectral_bins; ++spectral_bin) {
      const std::int32_t line = view.emitted_line<double>(0, band, spectral_bin);
      EXPECT_EQ(m.line[static_cast<std::size_t>(line)].process,
                band == 0 ? Process::raman : Process::cdom);
      ++count[static_cast<std::size_t>(line)];
    }
  }
  for (std::size_t l = 1; l < m.line.size(); ++l) {
    const auto same = [&](const Line& other) { return other.process == m.line[l].process; };
    double photons = 0;
    for (const Line& other : m.line) photons += same(other) ? other.photons : 0;
    const auto lines = static_cast<double>(std::ranges::count_if(m.line, same));
    EXPECT_NEAR(count[l], spectral_bins / 2.0 * (m.line[l].photons / photons + 1 / lines), 1) << l;
    EXPECT_NEAR(view.conversion.exact[l], m.conversion[l] * spectral_bins / count[l], 1e-15) << l;
  }
}

TEST(BuildMedium, RefusesMoreLinesThanThereAreHuesFor) {
  std::vector<scene::Channel> channels;
  for (int i = 0; i < 270; ++i) channels.push_back(test::filter(470 + 0.85 * i, 0.5));
  EXPECT_NE(refusal(spectra_scene(channels)).find("cut cdom light into"), std::string::npos);
}

}  // namespace
}  // namespace photic::medium
