#include "raylab/base/memory_limit.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <limits>

namespace raylab {

namespace {

// The limit of a control group, version 2 or 1; there is none for "max", or without such a file.
std::uint64_t control_group_memory() {
    std::uint64_t smallest = std::numeric_limits<std::uint64_t>::max(), bytes = 0;
    for (const char* file : {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"})
        if (std::ifstream(file) >> bytes) smallest = std::min(smallest, bytes);
    return smallest;
}

}  // namespace

std::uint64_t half_of_memory() {
    const auto machine =
        static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    return std::min(machine, control_group_memory()) / 2;
}

MemoryLimit what_is_left(const MemoryLimit& limit, double taken) {
    return {static_cast<std::uint64_t>(std::max(0.0, static_cast<double>(limit.bytes) - taken))};
}

void check_memory(const MemoryNeed& need, const MemoryLimit& limit, const Place& place) {
    if (need.bytes <= static_cast<double>(limit.bytes)) return;
    throw Error(place, fmt::format("at most {} (--memory)", bytes_in_words(static_cast<double>(limit.bytes))),
                fmt::format("{} that needs {}: {}", need.what, bytes_in_words(need.bytes), need.why));
}

MemoryLimit memory_limit_from_words(std::string_view words) {
    constexpr std::string_view units = "KMG";
    const auto unit = words.empty() ? units.npos : units.find(words.back());
    const auto digits = unit == units.npos ? words : words.substr(0, words.size() - 1);
    const unsigned shift = unit == units.npos ? 0 : 10 * (static_cast<unsigned>(unit) + 1);
    std::uint64_t number = 0;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (problem != std::errc{} || end != digits.data() + digits.size() || number == 0 || number >> (63 - shift) != 0)
        throw Error(fmt::format("expected --memory in bytes, or with K, M or G such as 4G, found '{}'", words));
    return {number << shift};
}

std::string bytes_in_words(double bytes) {
    constexpr std::array units{"KiB", "MiB", "GiB", "TiB"};
    if (bytes < 1024) return fmt::format("{} bytes", bytes);
    std::size_t unit = 0;
    for (bytes /= 1024; bytes >= 1024 && unit + 1 < units.size(); ++unit) bytes /= 1024;
    return fmt::format("{:.1f} {}", bytes, units[unit]);
}

}  // namespace raylab
