#pragma once

#include <string>
#include <string_view>

namespace raylab {

/// Bytes as text, four letters for three of them (RFC 4648), as data: addresses want them.
std::string base64(std::string_view bytes);

}  // namespace raylab
