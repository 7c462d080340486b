// The quality flags of a variable of a netCDF file.
#pragma once

#include <string>
#include <vector>

#include "scene/netcdf_flag_codes.hpp"
#include "scene/netcdf_shape.hpp"

namespace photic::scene {

/// The values of a profile after its flags.
struct Flagged {
  std::vector<bool> is_bad;          ///< or missing, of each value
  std::vector<std::string> dropped;  ///< the number of values by flag
  std::vector<std::string> remarks;  ///< on flags that are not understood
};

/// All flags of a variable.
class QualityFlags {
 public:
  /// Throws InputError for flags that explain themselves in two ways, or have other dimensions.
  QualityFlags(const NetcdfColumns& file, std::string variable);

  /// Judges the values at these positions; flags of those that are missing do not count. Throws
  /// InputError for flags that contradict each other, or should not be there.
  [[nodiscard]] Flagged judge(const std::vector<std::size_t>& positions,
                              const std::vector<double>& values) const;

 private:
  /// One variable of flags.
  struct Flags {
    std::string name;
    Shape shape;
    Alignment place;
    std::vector<std::size_t> index;  ///< of the code of each flag
    FlagCodes codes;
    bool is_listed;  ///< by ancillary_variables, of which each may judge by something else
    bool is_argos;
  };

  void add(const std::string& name, bool is_listed);
  /// The flag of a value; null if it has none. Throws if the flag should not be there.
  [[nodiscard]] const FlagCode* flag(const Flags& flags, std::size_t position) const;
  void judge_by(const Flags& flags, const std::vector<std::size_t>& positions,
                const std::vector<double>& values, Flagged& out) const;
  /// Throws if one calls a value bad that another calls good.
  void check_agreement(std::size_t position) const;

  const NetcdfColumns& file_;
  const std::string variable_;
  const Shape shape_;
  std::vector<Flags> flags_;
  std::vector<std::string> remarks_;
};

}  // namespace photic::scene
