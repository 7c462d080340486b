// Simulators of histories: the forward estimator, and what it scores beside the walks of the
// bidirectional one. Histories: one by one (one_by_one.hpp), or in lanes (pools.hpp).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "estimator/air.hpp"
#include "estimator/forward/beside_walks.hpp"
#include "estimator/forward/surface_echo.hpp"
#include "estimator/make_world.hpp"
#include "schedule/simulator.hpp"
#include "surface/oil.hpp"

namespace photic::schedule {

/// Histories of light that may go from one medium to the other.
template <class Histories>
class BothMedia {
 public:
  using World = estimator::World<typename Histories::Number>;

  /// The ledger's accounts are those of light that sets out in the water.
  void run(const World& setting_out, const World& water, const World& air, std::uint64_t first,
           std::uint64_t count, tally::BatchTally& tally) {
    typename Histories::Passed to_air(water), to_water(air);
    setting_out_.run(setting_out, first, count, tally, to_air);
    const tally::Ledger of_water = tally.ledger;
    air_.run(air, first, count, tally, to_water);
    while (to_air.photons.size() > 0 || to_water.photons.size() > 0) {
      air_.run(air, to_air, tally, to_water);
      water_.run(water, to_water, tally, to_air);
    }
    tally.ledger = of_water;
  }

 private:
  Histories setting_out_, water_, air_;
};

/// The forward estimator.
template <class Histories>
class ForwardSimulator final : public Simulator {
 public:
  using T = typename Histories::Number;

  explicit ForwardSimulator(estimator::World<T> world) : world_(std::move(world)) {}
  explicit ForwardSimulator(const estimator::Model& model)
      : world_(estimator::make_world<T>(model)) {
    if (model.air) air_.emplace(model, world_);
  }

  void add(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally) const override {
    if (air_) return both_media_.run(world_, world_, air_->air(), first, count, tally);
    histories_.run(world_, first, count, tally);
  }

 private:
  estimator::World<T> world_;
  std::optional<estimator::AirWorld<T>> air_;  ///< unless the air is clear
  mutable Histories histories_;
  mutable BothMedia<Histories> both_media_;
};

/// The surface's own echo beside walks.
template <class Histories>
class SurfaceEchoSimulator final : public Simulator {
 public:
  using T = typename Histories::Number;

  explicit SurfaceEchoSimulator(estimator::World<T> world) : world_(std::move(world)) {}

  void add(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally) const override {
    estimator::surface_echo<typename Histories::Ledger>(world_, first, count, tally);
  }

 private:
  estimator::World<T> world_;
};

/// The light of a film beside walks, and the surface's own echo.
template <class Histories>
class FilmSimulator final : public Simulator {
 public:
  using T = typename Histories::Number;

  explicit FilmSimulator(const estimator::Model& walks) : film_(walks) {}

  void add(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally) const override {
    histories_.run(film_.world(), first, count, tally);
  }

 private:
  estimator::FilmBesideWalks<T> film_;
  mutable Histories histories_;
};

/// Light that is scattered in both media beside walks.
template <class Histories>
class BothMediaSimulator final : public Simulator {
 public:
  using T = typename Histories::Number;

  explicit BothMediaSimulator(const estimator::Model& walks) : worlds_(walks) {}

  void add(std::uint64_t first, std::uint64_t count, tally::BatchTally& tally) const override {
    both_media_.run(worlds_.setting_out, worlds_.water, worlds_.air, first, count, tally);
  }

 private:
  estimator::BothMediaBesideWalks<T> worlds_;
  mutable BothMedia<Histories> both_media_;
};

template <class Histories>
BesideWalks beside_walks(const estimator::Model& model) {
  using T = typename Histories::Number;
  const auto sea = model.medium.view();
  BesideWalks out;
  if (surface::film_shines(sea))
    out.in_water = std::make_unique<FilmSimulator<Histories>>(model);
  else if (!sea.surface.one_direction_each)
    out.in_water =
        std::make_unique<SurfaceEchoSimulator<Histories>>(estimator::make_world<T>(model));
  if (model.air) out.in_air = std::make_unique<BothMediaSimulator<Histories>>(model);
  return out;
}

}  // namespace photic::schedule
