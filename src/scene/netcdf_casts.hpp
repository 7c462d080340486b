// The values of a netCDF file's variables that belong to one profile.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/netcdf_cast_ids.hpp"
#include "scene/netcdf_levels.hpp"

namespace photic::scene {

/// The positions of one profile's values and depths in their variables.
struct Cast {
  std::size_t number = 0;
  std::string label = {};  ///< "cycle_number 58"; empty where the number says all
  std::vector<std::size_t> value = {}, depth = {};
};

class Casts {
 public:
  /// Throws InputError for variables whose dimensions are not understood, or contradict each other.
  Casts(const NetcdfColumns& file, const ProfileVariable& value, const ProfileVariable& depth);

  /// Throws InputError for one that is not there, or for none where there are several; but of two
  /// dimensions it is the first then.
  [[nodiscard]] Cast chosen(std::optional<std::int64_t> profile) const;
  /// The numbers of those that have any values.
  [[nodiscard]] std::vector<std::size_t> numbers() const;
  [[nodiscard]] Cast cast(std::size_t number) const;

  [[nodiscard]] const Layout& layout() const { return layout_; }
  /// On values that are in no cast.
  [[nodiscard]] const std::vector<std::string>& remarks() const { return remarks_; }

 private:
  struct Run {
    std::size_t begin, end;  ///< in the order
  };
  /// Values in the order of their casts.
  struct Grouping {
    std::vector<std::size_t> order;
    std::vector<Run> run;
  };

  static Grouping grouped(const std::vector<CastId>& ids, std::size_t values);
  [[nodiscard]] bool overlap_in_depth(const Grouping& parts, std::size_t first,
                                      std::size_t end) const;
  void drop_constant_ids();
  void use_times_and_places();
  void number_casts();
  [[nodiscard]] std::size_t first_id(const Run& run) const;
  [[nodiscard]] std::size_t count() const;
  [[nodiscard]] std::string label(const Run& run) const;
  [[nodiscard]] std::string ids_text() const;

  const NetcdfColumns& file_;
  const std::string name_;
  const NetcdfVariable& depth_;
  const Layout layout_;
  std::vector<CastId> ids_;
  Grouping groups_;
  bool is_numbered_ = false;  ///< by the first of the ids, which other ids do not divide
  std::vector<std::string> remarks_;
};

}  // namespace photic::scene
