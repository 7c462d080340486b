// Four doubles that walk together: the lane type that tests compare with the scalar, bit for bit.
#pragma once

#include "core/pack.hpp"

namespace photic::test {

inline constexpr std::size_t lanes = 4;
using Lanes4 = Pack<double, lanes>;
using Index4 = Index<Lanes4>;
using Mask4 = Mask<Lanes4>;

}  // namespace photic::test
