// Results and tables as datasets. Their layout is documented in docs/guide.md.
#pragma once

#include "io/dataset.hpp"
#include "io/netcdf.hpp"
#include "io/optics_file.hpp"
#include "io/spectral_table.hpp"
#include "medium/optical_table.hpp"
#include "tally/result.hpp"

namespace photic::io {

/// All of a result but its state.
void describe(const tally::Result& result, const WriteInfo& info, Dataset& dataset);

void describe(const medium::OpticalTable& table, const OpticsOrigin& origin, Dataset& dataset);

void describe(const SpectralTable& table, const OpticsOrigin& origin, Dataset& dataset);

}  // namespace photic::io
