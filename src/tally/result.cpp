#include "tally/result.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace photic::tally {

const std::vector<FlagMeaning>& flag_meanings() {
  static const std::vector<FlagMeaning> meanings{
      {no_score, "no_score", "no light was ever scored there"},
      {few_batches, "few_batches", "fewer than 30 batches: the error itself is not known"},
      {large_error, "large_error",
       "the standard error, with all that may be unseen, is above 10 % of the value"},
      {uncertain_variance, "uncertain_variance", "one batch carries much of the variance"},
      {heavy_tail, "heavy_tail",
       "scores too rare to have been seen may add up to more than the error"},
      {among_flagged, "among_flagged", "most of the gates around it are flagged"},
      {beam_missed, "beam_missed",
       "the telescope's walks hardly found the laser's light: more photons, or the forward "
       "estimator"},
  };
  return meanings;
}

const GridEstimates& Result::grid(std::string_view name) const {
  const auto found =
      std::ranges::find(grids, name, [](const GridEstimates& g) { return g.grid.name; });
  if (found == grids.end()) throw std::out_of_range("no grid " + std::string(name));
  return *found;
}
GridEstimates& Result::grid(std::string_view name) {
  return const_cast<GridEstimates&>(std::as_const(*this).grid(name));
}

}  // namespace photic::tally
