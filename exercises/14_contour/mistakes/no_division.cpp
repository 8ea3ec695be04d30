// hint: two_pi_missing
#include "raylab/radiosity/form_factor/contour_form_factor.h"

#include <cmath>
#include <vector>

double raylab::contour_form_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> polygon) {
    double total = 0;
    for (std::size_t k = 2; k < polygon.size(); ++k) {
        const Vec3d corners[] = {polygon[0] - point, polygon[k - 1] - point, polygon[k] - point};
        std::vector<Vec3d> above;
        for (int i = 0; i < 3; ++i) {
            const Vec3d a = corners[i], b = corners[(i + 1) % 3];
            const double from = dot(normal, a), to = dot(normal, b);
            if (from > 0) above.push_back(a);
            if (from * to < 0) above.push_back((a * to - b * from) / (to - from));
        }
        for (std::size_t i = 0; i < above.size(); ++i) {
            const Vec3d a = above[i], b = above[(i + 1) % above.size()], across = cross(b - a, a);
            const double length = glm::length(across);
            if (length > 0) total += std::atan2(length, dot(a, b)) * dot(normal, across) / length;
        }
    }
    return total > 0 ? total : 0;
}
