#include "raylab/transport/lobe/rough_lobe.h"

#include "raylab/sampling/mapping/ggx.h"
#include "raylab/tracer/refracted_direction.h"
#include "raylab/tracer/shading/fresnel.h"

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

// The facet that sends light from wi to wo, and the steradians of normals for each steradian of wi.
struct Facet {
    Vec3d normal;
    double normals_per_direction;
};

// Absent where no facet does: normals point to the side of wo, and a facet is seen from its front.
std::optional<Facet> facet_between(const RoughLobe& lobe, const Vec3d& wo, const Vec3d& wi) {
    if (!(wo.z > 0) || wi.z == 0) return std::nullopt;
    if (wi.z > 0) {
        const Vec3d normal = glm::normalize(wo + wi);
        return Facet{normal, 1 / (4 * dot(wi, normal))};
    }
    // Snell's law: the sum leads along the normal, to the side of the smaller index.
    const Vec3d along = lobe.ior_here * wo + lobe.ior_behind * wi;
    const double length = glm::length(along);
    const Vec3d normal = along / (along.z < 0 ? -length : length);
    const double cosine = -dot(wi, normal);
    if (!(cosine > 0) || !(dot(wo, normal) > 0)) return std::nullopt;
    return Facet{normal, lobe.ior_behind * lobe.ior_behind * cosine / (length * length)};
}

MirroredShare share_at(const RoughLobe& lobe, double cosine) {
    return mirrored_share(lobe.kr, lobe.kt, cosine, lobe.ior_here, lobe.ior_behind, lobe.shares);
}

// How often a sample is to be mirrored. By Fresnel's equations facets differ from the smooth surface, so neither way
// becomes rare.
double chance_to_mirror(const RoughLobe& lobe, const Vec3d& wo) {
    if (lobe.kt == 0 || lobe.shares == FacetShares::coefficients) return lobe.kr / (lobe.kr + lobe.kt);
    return std::clamp(fresnel(wo.z, lobe.ior_here, lobe.ior_behind), 0.1, 0.9);
}

}  // namespace

Color RoughLobe::value(const Vec3d& wo, const Vec3d& wi) const {
    const auto facet = facet_between(*this, wo, wi);
    if (!facet) return Color(0);
    const auto [mirrored, refracted] = share_at(*this, dot(wo, facet->normal));
    return Color((wi.z > 0 ? mirrored : refracted) * ggx_unmasked(wi, alpha) *
                 ggx_visible_normal_pdf(wo, alpha, facet->normal) * facet->normals_per_direction);
}

double RoughLobe::pdf(const Vec3d& wo, const Vec3d& wi) const {
    const auto facet = facet_between(*this, wo, wi);
    if (!facet) return 0;
    const double to_mirror = chance_to_mirror(*this, wo);
    const bool refracts = share_at(*this, dot(wo, facet->normal)).refracted > 0;
    const double chance = wi.z > 0 ? (refracts ? to_mirror : 1) : (refracts ? 1 - to_mirror : 0);
    return chance * ggx_visible_normal_pdf(wo, alpha, facet->normal) * facet->normals_per_direction;
}

// The first number chooses between mirroring and refracting, and what is left of it is as good as new.
std::optional<LobeSample> RoughLobe::sample(const Vec3d& wo, const std::array<double, 2>& numbers) const {
    if (!(wo.z > 0)) return std::nullopt;
    const double to_mirror = chance_to_mirror(*this, wo);
    const bool mirrors = numbers[0] < to_mirror;
    const double rest = mirrors ? numbers[0] / to_mirror : (numbers[0] - to_mirror) / (1 - to_mirror);
    const Vec3d facet = ggx_visible_normal(wo, alpha, rest, numbers[1]);
    const auto refracted = mirrors ? std::nullopt : refracted_direction(-wo, facet, ior_here, ior_behind);
    const Vec3d direction = refracted ? *refracted : 2 * dot(wo, facet) * facet - wo;
    if (!(refracted ? direction.z < 0 : direction.z > 0)) return std::nullopt;
    const double density = pdf(wo, direction);
    if (!(density > 0)) return std::nullopt;
    return LobeSample{direction, value(wo, direction) / density, density};
}

}  // namespace raylab
