#pragma once

#include "race.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace raylab::bench {

/// A peer with its number of threads.
struct Racer {
    std::string peer;
    int threads = 1;

    friend bool operator==(const Racer&, const Racer&) = default;
};
inline Racer racer(const Row& row) { return {row.peer, row.threads}; }

/// Something that a row measures, and which rows count.
using Quantity = std::function<double(const Row&)>;
using Counts = std::function<bool(const Row&)>;

/// The geometric mean of the ratios of a quantity, of one racer over that of another, over the meshes and rays that
/// both have and that count; absent where there are none.
std::optional<double> mean_ratio(const std::vector<Row>& rows, const Racer& one, const Racer& base,
                                 const Quantity& quantity, const Counts& counts);

// Quantities and rows that count, for it. (Aimed rays are not for speed.)
inline double speed_of(const Row& row) { return row.rays_per_second; }
inline double build_time_of(const Row& row) { return row.build_seconds; }
inline double bytes_of(const Row& row) { return static_cast<double>(row.bytes); }
inline bool is_closest(const Row& row) { return row.question == RayQuestion::nearest && row.rays != "aimed"; }
inline bool is_any(const Row& row) { return row.question == RayQuestion::any; }
inline bool is_timed(const Row& row) { return row.rays != "aimed"; }

/// "0.97"; with two digits where it is small, and "" where it is absent.
std::string ratio_text(std::optional<double> ratio);

}  // namespace raylab::bench
