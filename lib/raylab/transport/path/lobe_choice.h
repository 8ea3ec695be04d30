#pragma once

#include "raylab/transport/lobe/material_lobes.h"
#include "raylab/transport/path/transport_options.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace raylab {

/// The chances with which a path goes on from each lobe of a surface: in proportion to what they reflect of light that
/// falls straight on them. They sum to 1, or are all 0 where no path goes on.
struct LobeChoice {
    static constexpr std::size_t mirrored = 3, refracted = 4;  // the sharp ones, after the spread ones
    std::array<double, 5> chances{};

    bool any() const { return chances != decltype(chances){}; }

    struct Chosen {
        std::size_t lobe;
        double chance;
    };
    /// The lobe that a number in [0, 1) stands for; some chance is not 0.
    Chosen at(double u) const {
        std::size_t last = 0;
        for (std::size_t i = 0; i < chances.size(); ++i) {
            if (chances[i] == 0) continue;
            last = i;
            if (u < chances[i]) break;
            u -= chances[i];
        }
        return {last, chances[last]};
    }

    /// The same for the number that draw() gives, which is not asked for where one lobe is all there is.
    template <class Draw>
    Chosen chosen(const Draw& draw) const {
        std::size_t first = 0;
        while (chances[first] == 0) ++first;
        return chances[first] == 1 ? Chosen{first, 1} : at(draw());
    }
};

// In proportion to these.
inline double share_followed(const DiffuseLobe& diffuse, Followed followed) {
    const Color& c = diffuse.albedo;
    return followed == Followed::all ? std::max({c.x, c.y, c.z}) : 0;
}
inline double share_followed(const GlossLobe& gloss, Followed) { return gloss.k; }
inline double share_followed(const RoughLobe& rough, Followed) { return rough.kr + rough.kt; }

template <class Lobes>
LobeChoice lobe_choice(const Lobes& lobes, Followed followed) {
    LobeChoice choice;
    for (std::size_t i = 0; i < lobes.spread.size(); ++i)
        choice.chances[i] =
            std::visit([&](const auto& lobe) { return share_followed(lobe, followed); }, lobes.spread[i]);
    choice.chances[LobeChoice::mirrored] = lobes.mirrored;
    choice.chances[LobeChoice::refracted] = lobes.refracted;
    double sum = 0;
    for (const double chance : choice.chances) sum += chance;
    if (sum > 0)
        for (double& chance : choice.chances) chance /= sum;
    return choice;
}

/// The density per steradian of the directions that the spread lobes choose, together.
template <class Lobes>
double density(const Lobes& lobes, const LobeChoice& choice, const Vec3d& wo, const Vec3d& wi) {
    double sum = 0;
    for (std::size_t i = 0; i < lobes.spread.size(); ++i)
        if (choice.chances[i] > 0) sum += choice.chances[i] * pdf(lobes.spread[i], wo, wi);
    return sum;
}

}  // namespace raylab
