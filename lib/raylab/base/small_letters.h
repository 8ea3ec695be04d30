#pragma once

#include <string>
#include <string_view>

// Words in which capitals make no difference. Only ASCII has them here: other letters stay as they are.

namespace raylab {

/// ASCII capitals made small.
std::string in_small_letters(std::string_view text);

/// Whether both are the same in small letters.
bool equal_ignoring_case(std::string_view a, std::string_view b);

}  // namespace raylab
