// What the engine scores for one path, strategy by strategy.
#pragma once

#include <cmath>

#include "estimator/bidirectional/connections.hpp"
#include "support/ship_scene.hpp"
#include "tally/batch_tally.hpp"
#include "unit/estimator/strategies.hpp"

namespace photic::estimator {

/// Scores of one telescope whose group path is within a tenth of a millimetre of a path's: other
/// connections of the same walks are left out, and wrong path lengths too.
struct Window {
  Window(const medium::Medium& medium, double path) : gates(scene(path), medium.line) {
    shape.telescopes = shape.channels = shape.gates = 1;
    shape.grids =
        tally::echo_grids(8, std::vector<std::string>(transport::kinds_touched, "some"), {0, 1});
    for (std::size_t l = 0; l < medium.line.size(); ++l)
      shape.channels_of_line.push_back({tally::Counting{0}});
    for (std::int32_t touched = 0; touched < transport::kinds_touched; ++touched)
      shape.process_of_light.insert(shape.process_of_light.end(), medium.line.size(), touched);
  }
  static scene::Scene scene(double path) {
    auto scene = test::ship_scene();
    scene.gates.depth_m.reset();
    scene.gates.time_ns = {(path - 1e-4) / metre_per_nanosecond,
                           (path + 1e-4) / metre_per_nanosecond, 2e-4 / metre_per_nanosecond};
    return scene;
  }
  tally::Shape shape;
  tally::Gates gates;
};

inline constexpr MeetingGrid<double> grid{2};

/// What the engine scores for a path by each strategy that draws it, by name.
class Scores {
 public:
  Scores(const World<double>& world, const Samples<double>& samples, const medium::Medium& medium,
         const Path& path, double length)
      : world_(world),
        samples_(samples),
        path_(path),
        window_(medium, length),
        tally_(window_.shape, window_.gates) {
    receiver_ = {0, 0, 0, world.instruments.telescope_region[0], path.line, -1, 1e4, 1e4};
  }

  double connecting(std::int32_t edge) {
    return connecting(edge, laser_walk(world_, samples_, path_, edge, false),
                      telescope_walk(world_, samples_, path_, path_.order() - edge, false));
  }
  /// By walks that have drawn all but the edge.
  double connecting(std::int32_t edge, const Walks<double>& laser, const Walks<double>& back) {
    Connections<double> connections(world_, receiver_, samples_, laser, back, tally_);
    if (edge == 0) {
      connections.to_laser(0);
    } else if (edge == path_.order()) {
      connections.to_telescope(0);
    } else {
      connections.between(0);
    }
    return taken();
  }
  /// By walks whose rays meet if one of them is moved.
  double meeting(const Walks<double>& laser, const Walks<double>& back, Moves moves) {
    Connections<double>(world_, receiver_, samples_, laser, back, tally_).meetings(0, 1, 0, moves);
    return taken();
  }

  /// Connecting edge 0 by a telescope's walk that goes on to other places and is converted there.
  double connecting_first_of_a_longer(const Path& longer) {
    const auto back = telescope_walk(world_, samples_, longer, longer.order(), false);
    Connections<double>(world_, receiver_, samples_, back, back, tally_).to_laser(0);
    return taken();
  }

  /// The telescope's walk is that of another path, which is translated sideways.
  double translated(std::int32_t i, const Path& other) {
    return meeting(
        laser_walk(world_, samples_, path_, i - 1, true),
        telescope_walk(world_, samples_, other, path_.order() - i, true, offset_at(i, grid)),
        Moves::translations);
  }

  /// The telescope's walk is that of another path, all of whose vertices are elsewhere.
  double free_telescope(std::int32_t i, const Path& other) {
    return meeting(laser_walk(world_, samples_, path_, i - 1, true),
                   telescope_walk(world_, samples_, other, path_.order() - i, true,
                                  offset_at(i, samples_.free_telescope)),
                   Moves::free_telescope);
  }
  /// The laser's walk is.
  double free_laser(std::int32_t i, const Path& other) {
    return meeting(laser_walk(world_, samples_, other, i - 1, true),
                   telescope_walk(world_, samples_, path_, path_.order() - i, true,
                                  offset_at(i, samples_.free_laser)),
                   Moves::free_laser);
  }

  /// The telescope's walk is that of another path, which is otherwise rotated.
  double rotated(std::int32_t i, const Path& other) {
    return meeting(laser_walk(world_, samples_, path_, i - 1, true),
                   telescope_walk(world_, samples_, other, path_.order() - i, true),
                   Moves::rotations);
  }

  /// Of a grid's points of which one lies where rays meet at vertex i; on the bed, below it.
  [[nodiscard]] double offset_at(std::int32_t i, const MeetingGrid<double>& of) const {
    const double number = of.number(-path_.x(i).z, path_.order()) +
                          (on_bed(world_.slabs, path_.x(i))
                               ? 0.05 * of.density(path_.order()) * samples_.grid.below_bed()
                               : 0);
    return number - std::floor(number);
  }

 private:
  double taken() {
    const double sum = tally_.parts[static_cast<std::size_t>(path_.order())];
    const bool bed = std::ranges::any_of(
        path_.vertex, [this](const V& place) { return on_bed(world_.slabs, place); });
    const auto touched = world_.slabs.kind == medium::MediumKind::air ? transport::Touched::air
                         : bed                                        ? transport::Touched::bed
                                                                      : transport::Touched::water;
    EXPECT_EQ(tally_.parts[tally_.grids[1].offset + static_cast<std::size_t>(touched)], sum)
        << "of what it has touched";
    tally_.clear();
    return sum;
  }

  const World<double>& world_;
  const Samples<double>& samples_;
  const Path& path_;
  Receiver<double> receiver_;
  Window window_;
  tally::BatchTally tally_;
};

}  // namespace photic::estimator
