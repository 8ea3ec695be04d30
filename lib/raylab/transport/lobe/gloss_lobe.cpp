#include "raylab/transport/lobe/gloss_lobe.h"

#include "raylab/geometry/local_frame.h"
#include "raylab/sampling/mapping/power_cosine.h"

#include <cmath>

namespace raylab {

// f is the lobe's density times k (n + 2) / (n + 1).
Color GlossLobe::value(const Vec3d&, const Vec3d& wi) const {
    if (!(wi.z * axis.z > 0)) return Color(0);
    return Color(k * (exponent + 2) / (exponent + 1) * power_cosine_pdf(exponent, dot(wi, axis)) * std::abs(wi.z));
}

double GlossLobe::pdf(const Vec3d&, const Vec3d& wi) const {
    return wi.z * axis.z > 0 ? power_cosine_pdf(exponent, dot(wi, axis)) : 0;
}

std::optional<LobeSample> GlossLobe::sample(const Vec3d&, const std::array<double, 2>& numbers) const {
    const Vec3d local = power_cosine_direction(exponent, numbers[0], numbers[1]);
    const Vec3d direction = frame_around(axis).to_world(local);
    const double pdf = power_cosine_pdf(exponent, local.z);
    if (!(direction.z * axis.z > 0) || !(pdf > 0)) return std::nullopt;
    return LobeSample{direction, Color(k * (exponent + 2) / (exponent + 1) * std::abs(direction.z)), pdf};
}

}  // namespace raylab
