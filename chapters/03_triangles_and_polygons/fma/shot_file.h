#pragma once

#include "raylab/geometry/ray.h"
#include "raylab/geometry/shapes.h"

#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace raylab {

/// Rays and the triangles each is tested against, in the binary form in which they are passed to another program.
struct ShotFile {
    std::vector<Triangle> triangles;
    std::vector<Vec3f> origins, directions;
    std::vector<std::uint32_t> first;  // ray i is tested against asked[first[i]] .. asked[first[i + 1]]
    std::vector<std::uint32_t> asked;  // indices of triangles
};

namespace detail {

template <class T>
void append(std::string& bytes, const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    const auto count = static_cast<std::uint64_t>(values.size());
    bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

template <class T>
std::vector<T> take(const std::string& bytes, std::size_t& at) {
    std::uint64_t count = 0;
    std::memcpy(&count, bytes.data() + at, sizeof count);
    at += sizeof count;
    std::vector<T> values(count);
    std::memcpy(values.data(), bytes.data() + at, count * sizeof(T));
    at += count * sizeof(T);
    return values;
}

}  // namespace detail

inline std::string to_bytes(const ShotFile& file) {
    std::string bytes;
    detail::append(bytes, file.triangles);
    detail::append(bytes, file.origins);
    detail::append(bytes, file.directions);
    detail::append(bytes, file.first);
    detail::append(bytes, file.asked);
    return bytes;
}

/// The bytes are not checked, because both programs belong to this chapter.
inline ShotFile from_bytes(const std::string& bytes) {
    std::size_t at = 0;
    ShotFile file;
    file.triangles = detail::take<Triangle>(bytes, at);
    file.origins = detail::take<Vec3f>(bytes, at);
    file.directions = detail::take<Vec3f>(bytes, at);
    file.first = detail::take<std::uint32_t>(bytes, at);
    file.asked = detail::take<std::uint32_t>(bytes, at);
    return file;
}

}  // namespace raylab
