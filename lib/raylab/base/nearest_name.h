#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace raylab {

/// The number of letters that must be inserted, removed, replaced or swapped with their neighbour to turn one name into
/// the other.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// `"raduis" (did you mean "radius"?)`, or just `"raduis"` where no known name is similar. Capitals count as small
/// letters, so that "edge-shot" is found for "EDGE-SHOT".
std::string with_suggestion(std::string_view name, std::span<const std::string> known);

}  // namespace raylab
