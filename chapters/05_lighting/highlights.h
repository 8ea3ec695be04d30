#pragma once

#include "raylab/experiment/measure/method.h"
#include "raylab/geometry/vector.h"

#include <cstdint>
#include <variant>
#include <vector>

// How bright is a highlight? Phong's term, and terms that have been used instead of it.

namespace raylab::lighting {

struct HighlightQuery {
    Vec3d normal, to_light, to_viewer;
    double shininess;
};

using HighlightMethod = Method<std::monostate, HighlightQuery, double>;
using HighlightWorkload = Workload<std::monostate, HighlightQuery>;

/// Phong's term by reflecting the light and by reflecting the viewer, in float and double; Blinn's half vector with the
/// same and with four times the exponent; Schlick's quotient instead of the power.
std::vector<HighlightMethod> highlight_methods();

/// The slot, which holds the student's function.
HighlightMethod your_highlight_method();

/// Points all over a lit sphere; points near the highlight only; the highlight of a nearly perfect mirror.
std::vector<HighlightWorkload> highlight_workloads(std::size_t points, std::uint64_t seed);

/// Phong's term computed from the angle itself, in long double.
double true_highlight(const HighlightQuery& query);

}  // namespace raylab::lighting
