#pragma once

#include "arguments.h"
#include "case.h"
#include "flat_view.h"
#include "truth.h"

namespace raylab::grading::normals {

/// The mapped surface from the side, in the plane of the right normal and of the answer.
inline PlaneDrawing sketch(const Case& question, std::span<const double> answer) {
    const Vec3d right = truth(arguments(question.input));
    const Vec3d yours{answer[0], answer[1], answer[2]};
    const bool is_vector = std::isfinite(dot(yours, yours));
    const Vec3d aside = is_vector ? yours - dot(yours, right) * right : Vec3d(0);
    FlatView view({-1.2, -1.2, 0}, {1.2, 1.2, 0}, "the mapped surface, and its normal",
                  "the surface from the side, in the plane of both");
    view.polygon({{-1.2, 0, 0}, {1.2, 0, 0}}, {.line = case_ink::given, .width = 2});
    view.arrow({0, 0, 0}, {0, 1, 0}, case_ink::right);
    view.dot({0, 1, 0}, case_ink::right, "right");
    if (is_vector) {
        // One that leaves the drawing is shown as long as there is room.
        const Vec3d end{glm::length(aside), dot(yours, right), 0};
        const Vec3d shown = end * std::min(1.0, 1.2 / std::max(glm::length(end), 1e-9));
        view.arrow({0, 0, 0}, shown, case_ink::yours);
        view.dot(shown, case_ink::yours, fmt::format("yours, {:.4g} long", glm::length(yours)));
    } else {
        view.text({0, -0.5, 0}, case_ink::yours, "yours: no number");
    }
    return view.drawn();
}

}  // namespace raylab::grading::normals
