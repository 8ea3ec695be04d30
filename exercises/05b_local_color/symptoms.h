#pragma once

#include "other_models.h"
#include "symptoms_of_falling_off.h"
#include "symptoms_of_the_highlight.h"
#include "symptoms_of_what_is_kept.h"

#include <utility>

// What wrong answers to this exercise have in common.

namespace raylab::grading::local {

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
    // The loop is left where a light is behind: without what was added up, or with it.
    add(instead("every_light", "where a light is behind the surface no light counts", [](const Arguments& g) {
        for (const IncidentLight& light : g.lights)
            if (!(seen_light(g.surface, light).incline > 0)) return g.surface.unlit;
        return truth(g);
    }));
    add(instead("every_light", "after a light behind the surface no light counts", [](const Arguments& g) {
        const auto behind = std::ranges::find_if(
            g.lights, [&](const IncidentLight& light) { return !(seen_light(g.surface, light).incline > 0); });
        return truth({g.surface, {g.lights.begin(), behind}});
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
    add(each_light("not_clamped", "no light arrives with more than 1",
                   [](const auto& s, const auto& l, const auto& seen) {
                       const auto [diffuse, specular] = terms_of(s, seen);
                       return clamped(l.color / seen.falls) * (diffuse + specular);
                   }));
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
    add(each_light("highlight_behind", "a light in the plane of the surface has a highlight",
                   [](const auto& s, const auto& l, const auto& seen) {
                       if (seen.incline != 0) return right_share(s, l, seen);
                       return l.color * highlight_by(s, seen.mirrored) * s.specular / seen.falls;
                   }));
    add(each_light("highlight_behind", "a light behind the surface, or in it, has a highlight opposite to it",
                   [](const auto& s, const auto& l, const auto& seen) {
                       if (seen.incline > 0) return right_share(s, l, seen);
                       return l.color * highlight_by(s, -dot(glm::normalize(l.way), s.to_viewer)) * s.specular /
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
    add(each_light("light_color", "the highlight has not the light's colour, and does not fall off",
                   [](const auto& s, const auto& l, const auto& seen) {
                       const auto [diffuse, specular] = terms_of(s, seen);
                       return l.color * diffuse / seen.falls + specular;
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
    // How bright a light is stands for its colour in the highlight: brightness(color).
    const auto colorless = [&](double (*brightness)(const Vec3d&)) {
        add(each_light("light_color", "the highlight is as bright as the light, and has not its colour",
                       [brightness](const auto& s, const auto& l, const auto& seen) {
                           const auto [diffuse, specular] = terms_of(s, seen);
                           return (l.color * diffuse + brightness(l.color) * specular) / seen.falls;
                       }));
    };
    colorless([](const Vec3d& c) { return (c.x + c.y + c.z) / 3; });
    colorless([](const Vec3d& c) { return std::max({c.x, c.y, c.z}); });
    colorless([](const Vec3d& c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; });
    colorless([](const Vec3d& c) { return 0.299 * c.x + 0.587 * c.y + 0.114 * c.z; });
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
    add(each_light("one_term", "a light without a highlight brings nothing",
                   [](const auto& s, const auto& l, const auto& seen) {
                       return seen.mirrored > 0 ? right_share(s, l, seen) : Vec3d(0);
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
    add_falling_off(all);
    add_what_is_kept(all);
    add(each_light("not_unit", "both terms are as if the way to the light were of length 1",
                   [](const auto& s, const auto& l, const auto& seen) {
                       if (!(seen.incline > 0)) return Vec3d(0);
                       const double d = seen.distance;
                       return l.color *
                              (d * seen.incline * s.diffuse + highlight_by(s, d * seen.mirrored) * s.specular) /
                              seen.falls;
                   }));
    add(each_light("not_unit", "the highlight's cosine grows with the distance",
                   [](const auto& s, const auto& l, const auto& seen) {
                       if (!(seen.incline > 0)) return Vec3d(0);
                       return l.color *
                              (seen.incline * s.diffuse + highlight_by(s, seen.distance * seen.mirrored) * s.specular) /
                              seen.falls;
                   }));
    add(each_light("not_unit", "the diffuse term grows with the distance",
                   [](const auto& s, const auto& l, const auto& seen) {
                       const auto [diffuse, specular] = terms_of(s, seen);
                       return l.color * (seen.distance * diffuse + specular) / seen.falls;
                   }));
    add_highlights(all);
    return of_numbers(std::move(all), {"negative_cosine"});
}

}  // namespace raylab::grading::local
