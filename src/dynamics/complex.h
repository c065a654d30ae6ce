#pragma once

#include <complex>

namespace evenload {

using Complex = std::complex<double>;
inline constexpr Complex kI{0, 1};

}  // namespace evenload
