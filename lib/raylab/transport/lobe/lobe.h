#pragma once

#include "raylab/transport/lobe/diffuse_lobe.h"
#include "raylab/transport/lobe/gloss_lobe.h"
#include "raylab/transport/lobe/rough_lobe.h"

#include <variant>

namespace raylab {

using Lobe = std::variant<DiffuseLobe, GlossLobe, RoughLobe>;

template <class... Kinds>
Color value(const std::variant<Kinds...>& lobe, const Vec3d& wo, const Vec3d& wi) {
    return std::visit([&](const auto& kind) { return kind.value(wo, wi); }, lobe);
}

template <class... Kinds>
double pdf(const std::variant<Kinds...>& lobe, const Vec3d& wo, const Vec3d& wi) {
    return std::visit([&](const auto& kind) { return kind.pdf(wo, wi); }, lobe);
}

template <class... Kinds>
std::optional<LobeSample> sample(const std::variant<Kinds...>& lobe, const Vec3d& wo,
                                 const std::array<double, 2>& numbers) {
    return std::visit([&](const auto& kind) { return kind.sample(wo, numbers); }, lobe);
}

}  // namespace raylab
