#pragma once

// The standard library that the exercise needs, so that no submission has to collect it.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <limits>
#include <numeric>
#include <queue>
#include <span>
#include <stack>
#include <utility>
#include <vector>

/// Larger than every finite distance: the `t` of a ray that hits nothing.
constexpr float infinity = std::numeric_limits<float>::infinity();

/// Where a ray starts to look for hits, so that it does not hit the surface it leaves from.
constexpr float epsilon = 1e-5f;

/// The smallest power of two that is not below `value`: 0 and 1 give 1, 5 gives 8.
///
/// `value` may be at most 2^31, because the next power does not fit into 32 bits.
constexpr uint32_t roundUpPowerOfTwo(uint32_t value) {
    return std::bit_ceil(value);
}
