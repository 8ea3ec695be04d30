#pragma once

#include "raylab/transport/lobe/diffuse_lobe.h"
#include "raylab/transport/lobe/gloss_lobe.h"
#include "raylab/transport/lobe/rough_lobe.h"

#include <variant>

namespace raylab {

using Lobe = std::variant<DiffuseLobe, GlossLobe, RoughLobe>;

/// What a lobe answers. Most are diffuse: asking for that first is faster than a jump (tests/bench/needs/measure).
template <class... Kinds>
auto asked(const std::variant<Kinds...>& lobe, const auto& ask) {
    if (const auto* diffuse = std::get_if<DiffuseLobe>(&lobe)) [[likely]]
        return ask(*diffuse);
    return std::visit(ask, lobe);
}

template <class... Kinds>
Color value(const std::variant<Kinds...>& lobe, const Vec3d& wo, const Vec3d& wi) {
    return asked(lobe, [&](const auto& kind) { return kind.value(wo, wi); });
}

template <class... Kinds>
double pdf(const std::variant<Kinds...>& lobe, const Vec3d& wo, const Vec3d& wi) {
    return asked(lobe, [&](const auto& kind) { return kind.pdf(wo, wi); });
}

template <class... Kinds>
std::optional<LobeSample> sample(const std::variant<Kinds...>& lobe, const Vec3d& wo,
                                 const std::array<double, 2>& numbers) {
    return asked(lobe, [&](const auto& kind) { return kind.sample(wo, numbers); });
}

}  // namespace raylab
