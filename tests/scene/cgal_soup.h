#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

/// Points and polygons as CGAL's reader of the file's format returns them.
struct Soup {
    std::vector<std::array<float, 3>> points;
    std::vector<std::vector<std::size_t>> polygons;
};

/// Absent: CGAL refuses the file.
std::optional<Soup> read_with_cgal(const std::filesystem::path& file);
