#pragma once

#include "raylab/geometry/vector.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace raylab {

struct FormFactorEstimate {
    double value;
    double standard_error = 0;  // of a random method
};

/// One way to answer the form factor between two convex polygons in full view, as a value: charts sweep the list,
/// stability cases and the program ask one of it.
struct FormFactorMethod {
    std::string name;          // "hemicube"
    std::string source;        // where to look it up
    std::string effort;        // what one of `effort` is: "pair", "pixel a side", ...; empty where it is not used
    std::vector<int> efforts;  // for a chart: from the least to the most
    std::function<std::optional<FormFactorEstimate>(std::span<const Vec3d> from, std::span<const Vec3d> to, int effort)>
        answer;

    /// "1 pair", "6 points a side"; empty where the effort is not used.
    std::string effort_text(int count) const;
    /// "contour, 6 points a side".
    std::string title(int count) const;
};

/// All of them, the cheapest kind first. Absent is the answer of a closed form that does not know the polygons.
const std::vector<FormFactorMethod>& form_factor_methods();

/// The method of that name; "area" stands for its low-discrepancy points, "auto" for `polygon`. An Error lists them.
const FormFactorMethod& form_factor_method_named(const std::string& name);

}  // namespace raylab
