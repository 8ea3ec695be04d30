// hint: behind_negative
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <cmath>
#include <numbers>
#include <vector>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    Vec3d sum{0, 0, 0};
    Vec3d first{0, 0, 0}, last{0, 0, 0};
    bool begun = false;
    const auto go_to = [&](const Vec3d& next) {
        if (begun) {
            const Vec3d across = cross(next - last, last);
            const double length = glm::length(across);
            if (length > 0) sum += across * (std::atan2(length, dot(last, next)) / length);
        } else {
            first = next;
        }
        begun = true;
        last = next;
    };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d a = polygon[i] - point, b = polygon[(i + 1) % polygon.size()] - point;
        const double height = dot(normal, a), next = dot(normal, b);
        if (height >= 0) go_to(a);
        if (height * next < 0) go_to(a + height / (height - next) * (b - a));
    }
    if (begun) go_to(first);
    return dot(normal, sum) / (2 * std::numbers::pi);
}
