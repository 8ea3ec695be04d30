#pragma once

#include <string>
#include <string_view>

namespace raylab {

/// The text with `by` at each place of `part`, which is not empty; what was put in is not searched again.
std::string with_all_replaced(std::string_view text, std::string_view part, std::string_view by);

}  // namespace raylab
