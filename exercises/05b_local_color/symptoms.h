#pragma once

#include "symptom.h"
#include "truth.h"

#include <functional>

// What wrong answers to this exercise have in common: the colour is that of the same model with something else in a
// place.

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

inline bool is_color(const WrongAnswer& w, const Vec3d& color) {
    const std::array<double, 3> numbers{color.x, color.y, color.z};
    return agree(w.given, numbers);
}

inline Symptom instead(const std::string& hint, const std::string& words,
                       const std::function<Vec3d(const Arguments&)>& color) {
    return {hint, words, [color](const WrongAnswer& w) { return is_color(w, color(arguments(w.question.input))); }};
}

inline Symptom each_light(const std::string& hint, const std::string& words, const Brings& brings) {
    return instead(hint, words,
                   [brings](const Arguments& given) { return given.surface.unlit + sum_of(given, brings); });
}

/// The right terms, divided by something else than the attenuation.
inline Symptom falls_by(const std::string& hint, const std::string& words, double (*divisor)(const Vec3d&, double)) {
    return each_light(hint, words, [divisor](const auto& surface, const auto& light, const auto& seen) {
        const auto [diffuse, specular] = terms_of(surface, seen);
        return light.color * (diffuse + specular) / divisor(light.attenuation, seen.distance);
    });
}

inline double highlight_by(const LocalSurface& surface, double cosine) {
    return cosine > 0 ? std::pow(cosine, surface.shininess) : 0;
}

inline Vec3d clamped(const Vec3d& color) { return glm::clamp(color, 0.0, 1.0); }

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    const auto right_sum = [](const Arguments& g) { return sum_of(g, right_share); };
    add(instead("unlit", "the colour that the point has without lights is missing", right_sum));
    add(instead("unlit", "the unlit colour is added once for each light", [right_sum](const Arguments& g) {
        return static_cast<double>(g.lights.size()) * g.surface.unlit + right_sum(g);
    }));
    add(instead("every_light", "only the first light counts", [](const Arguments& g) {
        return truth({g.surface, {g.lights.begin(), g.lights.begin() + (g.lights.empty() ? 0 : 1)}});
    }));
    add(instead("every_light", "only the last light counts", [](const Arguments& g) {
        return truth({g.surface, {g.lights.end() - (g.lights.empty() ? 0 : 1), g.lights.end()}});
    }));
    add(instead("sum_of_lights", "you take the mean of the lights", [right_sum](const Arguments& g) {
        return g.surface.unlit + right_sum(g) / std::max(1.0, static_cast<double>(g.lights.size()));
    }));
    add(instead("sum_of_lights", "of each channel the brightest light counts", [](const Arguments& g) {
        Vec3d most(0);
        for (const IncidentLight& light : g.lights)
            most = glm::max(most, right_share(g.surface, light, seen_light(g.surface, light)));
        return g.surface.unlit + most;
    }));
    add(instead("not_clamped", "no channel is more than 1", [](const Arguments& g) { return clamped(truth(g)); }));
    add(each_light("not_clamped", "no light brings more than 1",
                   [](const auto& s, const auto& l, const auto& seen) { return clamped(right_share(s, l, seen)); }));
    add(instead("unlit", "the unlit colour is multiplied by the diffuse colour",
                [right_sum](const Arguments& g) { return g.surface.unlit * g.surface.diffuse + right_sum(g); }));
    add(instead("unlit", "the unlit colour is added once for each light that is before the surface",
                [right_sum](const Arguments& g) {
                    const auto before = std::ranges::count_if(
                        g.lights, [&](const IncidentLight& light) { return seen_light(g.surface, light).incline > 0; });
                    return static_cast<double>(before) * g.surface.unlit + right_sum(g);
                }));
    add(instead("sum_of_lights", "you take the mean of the lights before the surface", [right_sum](const Arguments& g) {
        const auto before = std::ranges::count_if(
            g.lights, [&](const IncidentLight& light) { return seen_light(g.surface, light).incline > 0; });
        return g.surface.unlit + right_sum(g) / std::max(1.0, static_cast<double>(before));
    }));
    add(instead("unlit", "the unlit colour is dimmed with the light", [](const Arguments& g) {
        Vec3d sum(0);
        for (const IncidentLight& light : g.lights) {
            const auto seen = seen_light(g.surface, light);
            sum += right_share(g.surface, light, seen) + g.surface.unlit / seen.falls;
        }
        return sum;
    }));
    const auto signed_diffuse = [](const auto& s, const auto& l, const auto& seen) {
        const double highlight = seen.incline > 0 ? highlight_by(s, seen.mirrored) : 0;
        return l.color * (seen.incline * s.diffuse + highlight * s.specular) / seen.falls;
    };
    add(each_light("highlight_behind", "a light behind the surface, or in it, has a highlight",
                   [](const auto& s, const auto& l, const auto& seen) {
                       return l.color *
                              (std::max(0.0, seen.incline) * s.diffuse + highlight_by(s, seen.mirrored) * s.specular) /
                              seen.falls;
                   }));
    add(each_light("turned_away", "a light behind the surface takes light away", signed_diffuse));
    add(each_light("turned_away", "a light behind the surface takes light away, or has a highlight",
                   [](const auto& s, const auto& l, const auto& seen) {
                       return l.color * (seen.incline * s.diffuse + highlight_by(s, seen.mirrored) * s.specular) /
                              seen.falls;
                   }));
    add(each_light("turned_away", "a light behind the surface lights it from within",
                   [](const auto& s, const auto& l, const auto& seen) {
                       const double highlight = seen.incline > 0 ? highlight_by(s, seen.mirrored) : 0;
                       return l.color * (std::abs(seen.incline) * s.diffuse + highlight * s.specular) / seen.falls;
                   }));
    add(instead("turned_away", "a light behind the surface takes light away, down to black",
                [signed_diffuse](const Arguments& g) {
                    return glm::max(Vec3d(0), g.surface.unlit + sum_of(g, signed_diffuse));
                }));
    add(each_light("light_color", "the highlight has not the light's colour",
                   [](const auto& s, const auto& l, const auto& seen) {
                       const auto [diffuse, specular] = terms_of(s, seen);
                       return (l.color * diffuse + specular) / seen.falls;
                   }));
    add(each_light("light_color", "the diffuse term has not the light's colour",
                   [](const auto& s, const auto& l, const auto& seen) {
                       const auto [diffuse, specular] = terms_of(s, seen);
                       return (diffuse + l.color * specular) / seen.falls;
                   }));
    add(each_light("light_color", "the highlight has the light's colour twice",
                   [](const auto& s, const auto& l, const auto& seen) {
                       const auto [diffuse, specular] = terms_of(s, seen);
                       return l.color * (diffuse + l.color * specular) / seen.falls;
                   }));
    add(each_light("light_color", "the light's colour is not used", [](const auto& s, const auto&, const auto& seen) {
        const auto [diffuse, specular] = terms_of(s, seen);
        return (diffuse + specular) / seen.falls;
    }));
    add(each_light("plastic", "the highlight is coloured by the diffuse colour, too",
                   [](const auto& s, const auto& l, const auto& seen) {
                       const auto [diffuse, specular] = terms_of(s, seen);
                       return l.color * (diffuse + s.diffuse * specular) / seen.falls;
                   }));
    add(each_light("times_lambert", "the highlight is multiplied by the cosine at the light",
                   [](const auto& s, const auto& l, const auto& seen) {
                       const auto [diffuse, specular] = terms_of(s, seen);
                       return l.color * (diffuse + seen.incline * specular) / seen.falls;
                   }));
    add(each_light("one_term", "the highlight is missing", [](const auto& s, const auto& l, const auto& seen) {
        return l.color * terms_of(s, seen).diffuse / seen.falls;
    }));
    add(each_light("one_term", "the diffuse term is missing", [](const auto& s, const auto& l, const auto& seen) {
        return l.color * terms_of(s, seen).specular / seen.falls;
    }));
    add(each_light("exponent", "the highlight's cosine is not raised to the power",
                   [](const auto& s, const auto& l, const auto& seen) {
                       const Vec3d specular = seen.incline > 0 ? std::max(0.0, seen.mirrored) * s.specular : Vec3d(0);
                       return l.color * (terms_of(s, seen).diffuse + specular) / seen.falls;
                   }));
    add(each_light("exponent", "the diffuse cosine is raised to the power, too",
                   [](const auto& s, const auto& l, const auto& seen) {
                       return l.color * (highlight_by(s, seen.incline) * s.diffuse + terms_of(s, seen).specular) /
                              seen.falls;
                   }));
    add(falls_by("attenuation", "the light does not fall off", [](const Vec3d&, double) { return 1.0; }));
    add(falls_by("attenuation", "the light falls off with 1 / d^2, whatever is given",
                 [](const Vec3d&, double d) { return d * d; }));
    add(falls_by("attenuation", "the colour is multiplied by c + l d + q d^2",
                 [](const Vec3d& a, double d) { return 1 / (a.x + a.y * d + a.z * d * d); }));
    add(falls_by("attenuation", "the distance counts as 1", [](const Vec3d& a, double) { return a.x + a.y + a.z; }));
    add(falls_by("attenuation", "l and q have changed places",
                 [](const Vec3d& a, double d) { return a.x + a.z * d + a.y * d * d; }));
    add(falls_by("attenuation", "the linear coefficient is missing",
                 [](const Vec3d& a, double d) { return a.x + a.z * d * d; }));
    add(falls_by("attenuation", "you take d^2 for the distance",
                 [](const Vec3d& a, double d) { return a.x + a.y * d * d + a.z * d * d * d * d; }));
    add(falls_by("attenuation", "q is multiplied by d, and not by d^2",
                 [](const Vec3d& a, double d) { return a.x + a.y * d + a.z * d; }));
    add(falls_by("attenuation", "l is multiplied by d^2, and not by d",
                 [](const Vec3d& a, double d) { return a.x + a.y * d * d + a.z * d * d; }));
    add(falls_by("attenuation", "the light falls off with the square of c + l d + q d^2",
                 [](const Vec3d& a, double d) { return std::pow(a.x + a.y * d + a.z * d * d, 2); }));
    add(falls_by("attenuation", "the constant coefficient is missing",
                 [](const Vec3d& a, double d) { return a.y * d + a.z * d * d; }));
    add(falls_by("attenuation", "the quadratic coefficient is missing",
                 [](const Vec3d& a, double d) { return a.x + a.y * d; }));
    add(falls_by("attenuation", "the light is never brighter than beside it",
                 [](const Vec3d& a, double d) { return std::max(1.0, a.x + a.y * d + a.z * d * d); }));
    add(each_light("attenuation", "only the highlight falls off", [](const auto& s, const auto& l, const auto& seen) {
        const auto [diffuse, specular] = terms_of(s, seen);
        return l.color * (diffuse + specular / seen.falls);
    }));
    add(each_light("attenuation", "only the diffuse term falls off",
                   [](const auto& s, const auto& l, const auto& seen) {
                       const auto [diffuse, specular] = terms_of(s, seen);
                       return l.color * (diffuse / seen.falls + specular);
                   }));
    add(each_light("not_unit", "both terms are as if the way to the light were of length 1",
                   [](const auto& s, const auto& l, const auto& seen) {
                       if (!(seen.incline > 0)) return Vec3d(0);
                       const double d = seen.distance;
                       return l.color *
                              (d * seen.incline * s.diffuse + highlight_by(s, d * seen.mirrored) * s.specular) /
                              seen.falls;
                   }));
    add(each_light("not_unit", "the diffuse term grows with the distance",
                   [](const auto& s, const auto& l, const auto& seen) {
                       const auto [diffuse, specular] = terms_of(s, seen);
                       return l.color * (seen.distance * diffuse + specular) / seen.falls;
                   }));
    for (const int exponents : {1, 4})
        add(each_light("half_vector", "the highlight is Blinn's, by the half vector",
                       [exponents](const auto& s, const auto& l, const auto& seen) {
                           const double cosine = dot(s.normal, glm::normalize(s.to_viewer + glm::normalize(l.way)));
                           const double highlight = std::pow(highlight_by(s, cosine), exponents);
                           const Vec3d specular = seen.incline > 0 ? highlight * s.specular : Vec3d(0);
                           return l.color * (terms_of(s, seen).diffuse + specular) / seen.falls;
                       }));
    // The highlight by the cosine of another angle: cosine(surface, light, seen).
    const auto another_angle = [&](const std::string& words, const auto& cosine) {
        add(each_light("another_angle", words, [cosine](const auto& s, const auto& l, const auto& seen) {
            const double highlight = seen.incline > 0 ? highlight_by(s, cosine(s, l, seen)) : 0;
            return l.color * (terms_of(s, seen).diffuse + highlight * s.specular) / seen.falls;
        }));
    };
    another_angle("the highlight is where the mirror direction points into the surface",
                  [](const auto&, const auto&, const auto& seen) { return -seen.mirrored; });
    another_angle("the highlight is where the viewer looks along the normal",
                  [](const auto& s, const auto&, const auto&) { return dot(s.normal, s.to_viewer); });
    another_angle("the highlight is where the viewer looks from the light",
                  [](const auto& s, const auto& l, const auto&) { return dot(glm::normalize(l.way), s.to_viewer); });
    return all;
}

}  // namespace raylab::grading::local
