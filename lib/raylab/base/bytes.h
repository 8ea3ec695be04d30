#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>

// Numbers in the byte orders of binary files, on a machine of any byte order.

namespace raylab {

template <class T>
concept Number = std::integral<T> || std::floating_point<T>;

/// The number that starts at `offset`; it must lie inside `bytes`.
template <Number T>
T number_at(std::string_view bytes, std::size_t offset, std::endian order) {
    assert(offset <= bytes.size() && sizeof(T) <= bytes.size() - offset);
    std::array<char, sizeof(T)> raw;
    std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(offset), sizeof(T), raw.begin());
    if (order != std::endian::native) std::ranges::reverse(raw);
    return std::bit_cast<T>(raw);
}

/// Appends the bytes of a number.
template <Number T>
void append_number(std::string& bytes, T number, std::endian order) {
    auto raw = std::bit_cast<std::array<char, sizeof(T)>>(number);
    if (order != std::endian::native) std::ranges::reverse(raw);
    bytes.append(raw.data(), raw.size());
}

}  // namespace raylab
