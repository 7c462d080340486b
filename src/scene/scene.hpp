// The scene: what the user describes, as plain values under the names and units of the scene file.
// A value a Scene holds has been checked (scene/read.hpp); defaults are filled in.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/vec3.hpp"
#include "optics/minerals.hpp"
#include "scene/choices.hpp"
#include "scene/sea.hpp"
#include "scene/source.hpp"
#include "scene/user_table.hpp"

namespace photic::scene {

/// A Gaussian beam is cut off where it is so many times as wide as at 1/e2 of its peak.
inline constexpr double gaussian_cut = 3;

/// A thin lens with a circular detector behind it.
struct Telescope {
  std::string name;
  Vec3<double> position_m;  ///< centre of the lens
  Vec3<double> direction;   ///< of its view; any length but 0
  double diameter_m{};
  double focal_length_m{};
  std::optional<double> detector_diameter_m;  ///< exactly one of these two is given
  std::optional<double> half_field_of_view_mrad;
  double detector_shift_m = 0.0;  ///< from the focal plane, positive away from the lens
  std::optional<double> focus_m;  ///< in its place: the distance from the lens that is seen sharp
  double obstruction_diameter_m = 0.0;  ///< central

  /// The detector's diameter, whichever way it was given.
  [[nodiscard]] double effective_detector_diameter_m() const;
  /// The detector's shift, whichever way it was given.
  [[nodiscard]] double effective_detector_shift_m() const;
  /// From the lens to the detector.
  [[nodiscard]] double detector_distance_m() const;
  friend bool operator==(const Telescope&, const Telescope&) = default;
};

/// The light a detector behind one filter counts: all light of a process, or all processes through
/// a filter.
struct Channel {
  std::string name;
  std::optional<Process> process;
  std::optional<double> centre_nm;  ///< of a filter; both given or none
  std::optional<double> fwhm_nm;
  FilterShape filter = FilterShape::top_hat;
  std::optional<UserTable> transmission;  ///< of wavelength_nm, transmission
  friend bool operator==(const Channel&, const Channel&) = default;
};

/// The published data and models that the water's optics are made of.
struct Optics {
  OpticsSet set = OpticsSet::modern;
  std::string water_absorption;   ///< mason-ioccg | ioccg | pope-fry | smith-baker
  std::string water_scattering;   ///< zhang | morel | smith-baker
  double water_depolarisation{};  ///< of natural light, for the molecular phase function
  std::string phytoplankton;      ///< bricaud | prieur-sathyendranath | table
  UserTable phytoplankton_table;  ///< table
  ParticlePhase phytoplankton_phase{};
  MineralOptics minerals{};
  optics::MineralsPowerLaw minerals_power_law = optics::european_minerals;
  ParticlePhase minerals_phase{};
  std::string raman;                   ///< bartlett | marshall-smith
  std::optional<Emission> emission;    ///< given in every scene that has been read
  double chlorophyll_share_730 = 0.0;  ///< of chlorophyll's light in its second band
  CdomFluorescence cdom_fluorescence{};
  UserTable cdom_fluorescence_table;     ///< table
  double chlorophyll_lifetime_ns = 0.0;  ///< mean time from excitation to emission; 0: at once
  double cdom_lifetime_ns = 0.0;
  friend bool operator==(const Optics&, const Optics&) = default;
};

/// A layer of air, given outright.
struct AirLayer {
  std::string name;
  double bottom_height_m{}, top_height_m{};     ///< above the sea
  std::vector<IopEntry> iop;                    ///< a and b alone, ascending in wavelength
  std::optional<PhaseFunction> phase_function;  ///< none: that of the air's molecules
  double refractive_index = 1.0;                ///< at all wavelengths
  friend bool operator==(const AirLayer&, const AirLayer&) = default;
};

/// The absorption of gases besides ozone, from the sea straight up to a height.
struct AirGases {
  double top_km{};
  UserTable depth;  ///< of wavelength_nm, optical_depth
  friend bool operator==(const AirGases&, const AirGases&) = default;
};

/// The ground below air alone.
struct Ground {
  GroundKind kind = GroundKind::lambert;
  std::variant<double, UserTable> albedo = 0.0;  ///< lambert; as Bottom::albedo
  friend bool operator==(const Ground&, const Ground&) = default;
};

/// The air above the sea: a profile and its aerosols, or layers. Above it is a vacuum.
struct Atmosphere {
  std::variant<std::string, UserTable> profile;  ///< one of AFGL's six, or levels
  std::string aerosol = "rural";                 ///< of the boundary layer; none: of all the air
  std::optional<double> visibility_km;  ///< none: no aerosols, those of the levels, or as deep as:
  std::optional<double> aerosol_optical_depth_550;  ///< of all aerosols, from the sea to the top
  std::string season = "spring-summer";
  std::optional<double> relative_humidity_percent;  ///< of the boundary layer; none: the profile's
  double top_km = 100.0;
  std::vector<AirGases> gases;  ///< a ladder, from the sea up
  std::vector<AirLayer> layer;  ///< from the sea up; empty where there is a profile
  bool refraction = false;      ///< layers bend light
  AirGeometry geometry = AirGeometry::plane;
  double planet_radius_km = 6371.0;  ///< spherical; mean of the earth, rounded [moritz2000]
  std::optional<Ground> surface;     ///< in place of the sea: there is air alone

  [[nodiscard]] bool has_aerosols() const { return aerosol != "none"; }
  [[nodiscard]] bool is_spherical() const { return geometry == AirGeometry::spherical; }
  [[nodiscard]] double planet_radius_m() const { return 1000 * planet_radius_km; }
  friend bool operator==(const Atmosphere&, const Atmosphere&) = default;
};

/// A direction in which light travels: its angle from straight up, and its azimuth from +x to +y.
struct TravelDirection {
  double zenith_deg{}, azimuth_deg{};
  friend bool operator==(const TravelDirection&, const TravelDirection&) = default;
};

/// A quantity of radiative transfer that is tallied beside echoes.
struct Tally {
  TallyKind kind{};
  std::string name;  ///< fluence: what results call it; may be empty where there is but one
  /// Levels of irradiance and radiance, of one or of both; edges of a fluence, of one of them.
  std::vector<double> depth_m, height_m;
  std::optional<double> slab_m;    ///< irradiance; none: a twentieth of an attenuation length
  std::vector<double> zenith_deg;  ///< boundaries: edges of the angles of light that escapes
  /// Irradiance in spherical air: edges of zones about the point under the source, by the angle at
  /// the planet's centre.
  std::vector<double> zone_deg;
  std::vector<double> radius_m, x_m;           ///< fluence: edges, of one of them
  std::vector<TravelDirection> direction_deg;  ///< radiance
  friend bool operator==(const Tally&, const Tally&) = default;
};

/// Range gates by depth, by range along telescope 0's axis, or by time: exactly one kind
/// is given.
struct Gates {
  struct Interval {
    double min{}, max{}, step{};
    /// The number of gates: as many as steps begin between min and max. If the step does not divide
    /// that way, the gates are all equally long and a little shorter than it.
    [[nodiscard]] double steps() const;
    friend bool operator==(const Interval&, const Interval&) = default;
  };
  std::optional<Interval> depth_m;  ///< depth_min_m (default 0), depth_max_m, depth_step_m
  std::optional<Interval> range_m;  ///< range_min_m, range_max_m, range_step_m
  std::optional<Interval> time_ns;  ///< start_ns, stop_ns, step_ns
  std::int64_t depth_cells = 100;   ///< of echo_by_depth; 0: there is none

  [[nodiscard]] bool are_given() const;            ///< false: there are no telescopes
  [[nodiscard]] const Interval& interval() const;  ///< the one that is given
  [[nodiscard]] std::int64_t count() const;  ///< number of gates, from min to max; 0 without them
  friend bool operator==(const Gates&, const Gates&) = default;
};

/// From a depth on, how much a photon is worth there; above the first of them 1.
struct Importance {
  double depth_m{};
  double value{};
  friend bool operator==(const Importance&, const Importance&) = default;
};

/// The additions of the forward estimator to the plain walk (docs/theory.md, "The paper's tools").
struct Tools {
  std::int64_t forced_collisions = 0;  ///< so many first flights of a photon do not leave the water
  LocalForcedCollisions local_forced_collisions = LocalForcedCollisions::conversions;
  double weight_threshold = 0.1;  ///< of the analog weight, for:
  AtThreshold at_threshold = AtThreshold::roulette;
  std::vector<Importance> importance;  ///< ascending in depth
  friend bool operator==(const Tools&, const Tools&) = default;
  /// Returns whether more is asked for than another threshold of roulette, which every walk has.
  [[nodiscard]] bool any() const;
};

/// Photons of a batch that a scene may ask for.
inline constexpr std::int64_t min_batch_photons = 250, max_batch_photons = 8000;

struct Simulation {
  Estimator estimator = Estimator::automatic;
  std::optional<std::string> estimator_reason;  ///< reason for the choice of "auto"
  std::optional<std::uint64_t> photons;         ///< at least one of these three is given
  std::optional<double> target_relative_error;
  std::optional<double> max_time_s;
  std::optional<std::int64_t> max_order;  ///< none: no limit
  std::int64_t orders_kept = 6;
  std::uint64_t seed = 1;
  Reception reception = Reception::ray;  ///< forward
  /// Forward: share of directions drawn towards a telescope; 0 turns that off.
  std::optional<double> directed_fraction;
  /// Forward: of each flight; 1: where photons collide only. None of the two: forward_settings.hpp.
  std::optional<std::int64_t> scored_points;
  // Where one of the next four is not named: walk_settings.hpp, or by pilot runs.
  /// Of a branch into an inelastic process, per collision.
  std::optional<double> conversion_probability;
  /// Bidirectional: of the laser, and of each telescope, in a set.
  std::optional<std::int64_t> walks;
  /// Bidirectional: of two rays, if all depths of the gates let them meet.
  std::optional<double> meetings;
  /// Bidirectional: share of walks whose vertices are all connected.
  std::optional<double> connected_fraction;
  /// Bidirectional: of two rays by free walks, per metre of depth; none: by pilot runs, or 0.
  std::optional<double> free_telescope_meetings, free_laser_meetings;
  std::optional<double> walk_attenuation;  ///< bidirectional: share of c that free paths are drawn
                                           ///< from; none: as the water asks for
  Sampling sampling = Sampling::quasi_random;
  std::optional<std::uint64_t> batch_photons;  ///< none: by how many photons are asked for
  bool keep_groups = true;                     ///< of batches, unless they take too much room
  Tools tools;                                 ///< forward
  friend bool operator==(const Simulation&, const Simulation&) = default;
};

/// A value that is another one in an environment.
struct Change {
  std::string path;   ///< as of --set: "sea.layer.0.chlorophyll_mg_m3"
  std::string value;  ///< as TOML
  friend bool operator==(const Change&, const Change&) = default;
};

/// Other water and another bed, whose echoes are computed from the same histories.
struct Environment {
  std::string name;
  /// In the order of the file; all that they come to where the scene as it is written needs more.
  std::vector<Change> set;
  Optics optics;  ///< with the changes; all else is the scene's
  Sea sea;
  std::optional<Bottom> bottom = std::nullopt;
  std::optional<Oil> oil = std::nullopt;
  std::optional<Atmosphere> atmosphere = std::nullopt;
  friend bool operator==(const Environment&, const Environment&) = default;
};

/// A parameter with respect to which every echo is derived.
struct Sensitivity {
  std::string path;              ///< as of --set
  double value{};                ///< in the scene; not 0
  double step{};                 ///< of the central difference: a thousandth of the value, above 0
  Environment below{}, above{};  ///< the water with value - step and value + step
  friend bool operator==(const Sensitivity&, const Sensitivity&) = default;
};

struct Scene {
  std::string title;
  std::vector<Sensitivity> sensitivity;
  Source source;
  std::vector<Telescope> telescope;
  std::vector<Channel> channel;
  std::vector<Tally> tally;
  Optics optics;
  Sea sea;                               ///< without layers: there is air alone, above a ground
  std::optional<Bottom> bottom;          ///< none: black
  std::optional<Oil> oil;                ///< none: the sea is clean
  std::optional<Atmosphere> atmosphere;  ///< none: a vacuum
  Gates gates;
  Simulation simulation;
  std::vector<Environment> environment;

  /// The weight of light at facets: the surface's own, or that of the source.
  [[nodiscard]] FacetWeight facet_weight() const {
    const auto usual = source.is_pulsed() ? FacetWeight::reciprocal : FacetWeight::conserving;
    return sea.surface.facets.value_or(usual);
  }
  /// Returns whether there is a ground in place of the sea.
  [[nodiscard]] bool is_of_air_alone() const { return atmosphere && atmosphere->surface; }
  [[nodiscard]] bool is_of_spherical_air() const {
    return atmosphere && atmosphere->is_spherical();
  }
  /// The height of a place above the sea or the ground [m].
  [[nodiscard]] double height_of(const Vec3<double>& position) const;
  /// Returns whether echoes in other water are to be computed from the same histories.
  [[nodiscard]] bool has_environments() const {
    return !environment.empty() || !sensitivity.empty();
  }
  friend bool operator==(const Scene&, const Scene&) = default;
};

/// The scene without environments and sensitivities.
[[nodiscard]] Scene scene_alone(const Scene& scene);

/// The same with an environment's water.
[[nodiscard]] Scene scene_in(const Scene& scene, const Environment& environment);

}  // namespace photic::scene
