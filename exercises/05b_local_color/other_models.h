#pragma once

#include "symptom.h"
#include "truth.h"

#include <array>
#include <functional>

// The colour by the same model with something else in a place.

namespace raylab::grading::local {

/// What one light brings, by a model of one's own.
using Brings = std::function<Vec3d(const LocalSurface&, const IncidentLight&, const SeenLight&)>;

inline Vec3d right_share(const LocalSurface& surface, const IncidentLight& light, const SeenLight& seen) {
    const auto [diffuse, specular] = terms_of(surface, seen);
    return light.color * (diffuse + specular) / seen.falls;
}

inline Vec3d sum_of(const Arguments& given, const Brings& brings) {
    Vec3d sum(0);
    for (const IncidentLight& light : given.lights)
        sum += brings(given.surface, light, seen_light(given.surface, light));
    return sum;
}

/// Whether a wrong answer is this colour, which is not the right one: in few digits many answers are that.
inline bool is_color(const WrongAnswer& w, const Vec3d& color) {
    const std::array<double, 3> numbers{color.x, color.y, color.z};
    return agree(w.given, numbers) && !agree(w.right, numbers);
}

/// Whether a case tells this colour from the right one: such a case must be wrong.
inline bool is_another(const Vec3d& color, const Case& question) {
    const Vec3d right = truth(arguments(question.input));
    return !agree(std::array{color.x, color.y, color.z}, std::array{right.x, right.y, right.z});
}

inline Symptom instead(const std::string& hint, const std::string& words,
                       const std::function<Vec3d(const Arguments&)>& color) {
    return {hint, words, [color](const WrongAnswer& w) { return is_color(w, color(arguments(w.question.input))); },
            [color](const Case& question) { return is_another(color(arguments(question.input)), question); }};
}

inline Symptom each_light(const std::string& hint, const std::string& words, const Brings& brings) {
    return instead(hint, words,
                   [brings](const Arguments& given) { return given.surface.unlit + sum_of(given, brings); });
}

inline double highlight_by(const LocalSurface& surface, double cosine) {
    return cosine > 0 ? std::pow(cosine, surface.shininess) : 0;
}

inline Vec3d clamped(const Vec3d& color) { return glm::clamp(color, 0.0, 1.0); }

}  // namespace raylab::grading::local
