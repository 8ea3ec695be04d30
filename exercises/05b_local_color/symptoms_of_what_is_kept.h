#pragma once

#include "other_models.h"

#include <vector>

// What wrong answers have in common in which something of one light is still there when the next one comes: a variable
// that should begin anew for each of them.

namespace raylab::grading::local {

/// How far the loop has come: what the lights up to this one were divided by, and what they brought.
struct Kept {
    double sum_of_divisors = 0, product_of_divisors = 1, way = 0;
    Vec3d terms{0}, shares{0};
};

/// What a light brings where that of the lights before it, and its own, is kept; lights behind the surface leave
/// nothing where the loop passes over them at once.
inline Symptom keeps(const std::string& words,
                     Vec3d (*brings)(const LocalSurface&, const IncidentLight&, const SeenLight&, const Kept&)) {
    const auto sum = [brings](const Arguments& given, bool passes_over) {
        Kept kept;
        Vec3d all = given.surface.unlit;
        for (const IncidentLight& light : given.lights) {
            const SeenLight seen = seen_light(given.surface, light);
            if (passes_over && !(seen.incline > 0)) continue;
            const auto [diffuse, specular] = terms_of(given.surface, seen);
            kept.sum_of_divisors += seen.falls;
            kept.product_of_divisors *= seen.falls;
            kept.way += seen.distance;
            kept.terms += diffuse + specular;
            kept.shares += right_share(given.surface, light, seen);
            all += brings(given.surface, light, seen, kept);
        }
        return all;
    };
    return {"kept_from_the_light_before", words, [sum](const WrongAnswer& w) {
                const Arguments given = arguments(w.question.input);
                return is_color(w, sum(given, true)) || is_color(w, sum(given, false));
            }};
}

inline void add_what_is_kept(std::vector<Symptom>& all) {
    const auto add = [&](const std::string& words, auto brings) { all.push_back(keeps(words, brings)); };
    add("the second light is divided by the first one's divisor as well: they are added up",
        [](const auto& s, const auto& l, const auto& seen, const Kept& kept) {
            return right_share(s, l, seen) * seen.falls / kept.sum_of_divisors;
        });
    add("the second light is divided by the first one's divisor as well",
        [](const auto& s, const auto& l, const auto& seen, const Kept& kept) {
            return right_share(s, l, seen) * seen.falls / kept.product_of_divisors;
        });
    add("the second light falls off with both distances added up",
        [](const auto& s, const auto& l, const auto& seen, const Kept& kept) {
            const Vec3d& a = l.attenuation;
            return right_share(s, l, seen) * seen.falls / (a.x + a.y * kept.way + a.z * kept.way * kept.way);
        });
    add("what the first light brings is there once more with the second one",
        [](const auto&, const auto&, const auto&, const Kept& kept) { return kept.shares; });
    add("the second light has the first one's terms as well, in its own colour",
        [](const auto&, const auto& l, const auto& seen, const Kept& kept) {
            return l.color * kept.terms / seen.falls;
        });
    all.push_back(instead("kept_from_the_light_before", "the highlight of the light before is there once more",
                          [](const Arguments& given) {
                              Vec3d sum = given.surface.unlit, specular(0);
                              for (const IncidentLight& light : given.lights) {
                                  const SeenLight seen = seen_light(given.surface, light);
                                  if (!(seen.incline > 0)) continue;
                                  const Terms terms = terms_of(given.surface, seen);
                                  if (seen.mirrored > 0) specular = terms.specular;
                                  sum += light.color * (terms.diffuse + specular) / seen.falls;
                              }
                              return sum;
                          }));
}

}  // namespace raylab::grading::local
