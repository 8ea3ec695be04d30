#include "raylab/transport/lobe/diffuse_lobe.h"

#include "raylab/sampling/mapping/cosine_direction.h"

#include <algorithm>
#include <numbers>

namespace raylab {

Color DiffuseLobe::value(const Vec3d&, const Vec3d& wi) const {
    return albedo * (std::max(0.0, wi.z) / std::numbers::pi);
}

double DiffuseLobe::pdf(const Vec3d&, const Vec3d& wi) const { return std::max(0.0, wi.z) / std::numbers::pi; }

std::optional<LobeSample> DiffuseLobe::sample(const Vec3d& wo, const std::array<double, 2>& numbers) const {
    const auto [direction, pdf] = cosine_direction(numbers[0], numbers[1]);
    if (!(pdf > 0)) return std::nullopt;  // along the surface, where nothing arrives
    return LobeSample{direction, value(wo, direction) / pdf, pdf};
}

}  // namespace raylab
