#pragma once

#include "raylab/base/command_line.h"

#include <cstdint>
#include <optional>

// Options that many commands have, and read in the same way.

namespace raylab {

/// `--threads N`; without it: all cores.
Option threads_option();
/// How many threads are asked for; 0: all cores.
int threads_of(const Arguments& arguments);

/// Readers of JSON keep all whole numbers up to this one.
inline constexpr std::uint64_t largest_seed = (std::uint64_t{1} << 53) - 1;
/// The `--seed` of a command; absent where it has none.
std::optional<std::uint64_t> seed_if_given(const Arguments& arguments);

}  // namespace raylab
