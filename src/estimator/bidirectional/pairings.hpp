// Pairings of two walks: pairs of vertices and rays, the meetings of rays, and the paths that they
// make.
#pragma once

#include <cstddef>
#include <cstdint>

#include "estimator/bidirectional/meet.hpp"
#include "estimator/bidirectional/walk.hpp"
#include "geometry/sightline.hpp"

namespace photic::estimator {

/// A pairing: vertex or ray i of a laser's walk and m of a telescope's.
template <class T>
struct Pairing {
  Index<T> laser{}, i{}, back{}, m{};

  template <class F>
  constexpr void each_member(F f) {
    f(laser), f(i), f(back), f(m);
  }
};

template <class T>
Pairing<T> pairing_of(std::size_t laser, const Index<T>& i, std::size_t back, const Index<T>& m) {
  return {Index<T>(laser), i, Index<T>(back), m};
}

/// Rays i and m that may be made to meet, as they are or as the surface has reflected them.
template <class T>
struct RayPairing : Pairing<T> {
  Index<T> reflected{};  ///< 1: the laser's, 2: the telescope's, 3: both

  /// Vertices of the path that they make.
  [[nodiscard]] Index<T> order() const { return Pairing<T>::i + Pairing<T>::m + Index<T>(1); }
  [[nodiscard]] Mask<T> reflects_laser() const {
    return (reflected == Index<T>(1)) | (reflected == Index<T>(3));
  }
  [[nodiscard]] Mask<T> reflects_telescope() const { return reflected >= Index<T>(2); }
  template <class F>
  constexpr void each_member(F f) {
    Pairing<T>::each_member(f);
    f(reflected);
  }
};

/// Rays that meet at a depth if one walk is moved.
template <class T>
struct PlacedPairing : RayPairing<T> {
  T depth{};  ///< [m]

  template <class F>
  constexpr void each_member(F f) {
    RayPairing<T>::each_member(f);
    f(depth);
  }
};

/// The same of a free walk.
template <class T>
struct FreePairing : PlacedPairing<T> {
  Index<T> bed{};  ///< 1: they meet on the bed

  template <class F>
  constexpr void each_member(F f) {
    PlacedPairing<T>::each_member(f);
    f(bed);
  }
};

/// The moves of walks that are to meet others: a telescope's translated sideways so that it still
/// comes through the lens, or rotated beyond its pivot; or either as a free walk.
enum class Moves : std::int8_t { translations, rotations, free_telescope, free_laser, all };
inline bool includes(Moves asked, Moves one) { return asked == one || asked == Moves::all; }

/// Two rays that may be made to meet.
template <class T>
struct RayPair {
  using Ray = estimator::Ray<T>;
  Ray out, back;
  Spread<T> spread;      ///< of the laser's walk
  BirthRecord<T> birth;  ///< of the telescope's walk
  Index<T> rotates{};    ///< 1: it may be rotated about the vertical at ...
  T axis_x{}, axis_y{};
  RayPairing<T> pairing;
  LensLine<T> lens;  ///< its points on the lens, if it is translated

  /// About which the telescope's walk may be rotated.
  [[nodiscard]] RotationAxis<T> axis() const { return {rotates == Index<T>(1), axis_x, axis_y}; }
  template <class F>
  constexpr void each_member(F f) {
    out.each_member(f);
    back.each_member(f);
    spread.each_member(f);
    birth.each_member(f);
    f(rotates), f(axis_x), f(axis_y);
    pairing.each_member(f);
    f(lens.at_surface.x), f(lens.at_surface.y), f(lens.per_depth.x), f(lens.per_depth.y);
  }
};

/// The free walk of a path.
enum class Free : std::int8_t { none, telescope, laser };

/// The new way between a free walk's first vertex and its instrument.
template <class T>
struct NewLeg {
  Vertex<T> first;
  Ray<T> leaving;    ///< the walk's ray from there
  Vec3<T> arriving;  ///< direction in which the walk now comes there
  geometry::Sightline<T> way;
  geometry::Segment<T> in_water{};  ///< of that way
};

/// Two rays as they meet, after one of both walks has been moved, and what that makes of the path.
template <class T>
struct Met {
  Free free = Free::none;
  const NewLeg<T>* leg = nullptr;  ///< of a free walk
  const Ray<T>*out = nullptr, *back = nullptr;
  Spread<T> out_spread, back_spread;
  NearFirst<T> out_near, back_near;
  FreeArea<T> out_free, back_free;                 ///< if there are free walks
  const RotatedMeeting<T>* out_rotated = nullptr;  ///< at the first vertex, if not what it was
  T rest{1};  ///< by how much all other densities behind the telescope's ray grow
  T translation_area{};
  Vec3<T> out_moved{};        ///< from where the laser's walk was drawn; level
  RotationAxis<T> axis;       ///< of the telescope's walk, as it is now
  RotationAxis<T> own_axis;   ///< as it was drawn
  bool rotates_anew = false;  ///< it may be rotated otherwise than it was drawn
  T gain{1};                  ///< of the sample
  T longer{};                 ///< so much longer is the way from a tilted lens [m]
  Index<T> telescope{};       ///< the one that sees it
  // Under waves alone, and else not set, which takes time:
  instrument::PlanePoint<T> lens;   ///< the telescope's walk's point there now
  instrument::PlanePoint<T> moved;  ///< it, from where it was drawn; level
};

/// The meeting point of two rays.
template <class T>
struct MeetingPoint {
  T length_out{}, length_back{};  ///< of the rays [m]
  T tau{};                        ///< optical depth of both
  T reach_out{}, reach_back{};    ///< chances that walks would come along them
  Mask<T> converts{}, bed{};
  T coefficient{};  ///< of the event of light there, over c'
  T p{};            ///< density of the direction in which light leaves [1/sr]
  T path{};         ///< group path of both walks [m]
};

/// The edge from a vertex to a point of the lens, along which a telescope's walk might begin.
template <class T>
struct EdgeToTelescope {
  Mask<T> seen{};        ///< the detector sees it
  Index<T> telescope{};  ///< the narrowest of nested views that does
  geometry::Segment<T> in_water{};
  T path{};    ///< as the telescope's walks count it [m]
  T area{};    ///< across it, of the telescope's cone [m^2]
  T freed{1};  ///< of Spread
  T weight{};  ///< of a walk in the water, before it is attenuated
};

/// The way from a vertex to the laser.
template <class T>
struct WayToLaser {
  Mask<T> lit{};  ///< it comes to the laser within its cone
  geometry::Segment<T> in_water{};
  T path{};          ///< as the laser's walks count it [m]
  T tau{}, reach{};  ///< optical depth; chance that a walk of the laser would come along it
  T area{};          ///< across it, of the laser's cone [m^2]
  T freed{1};        ///< of Spread
  T weight{};        ///< of a walk of the laser in the water, before it is attenuated
};

/// A telescope's walk's first way in the water.
template <class T>
struct FirstLeg {
  T length{};  ///< [m]
  T steep{};   ///< cosine to the vertical
};

/// A path from the laser to a telescope, and what it scores.
template <class T>
struct FoundPath {
  T value{};                                     ///< expected photons
  T length{};                                    ///< group path [m]
  T last{};                                      ///< depth at which light was last scattered [m]
  Index<T> order{}, of_laser{}, of_telescope{};  ///< vertices: all, and those of the two walks
  Index<T> telescope{};                          ///< the narrowest of nested views that sees it
  Mask<T> met_on_bed{};
  Free free = Free::none;
};

}  // namespace photic::estimator
