#pragma once

#include "other_models.h"

#include <algorithm>
#include <cmath>

// What wrong answers have in common in which the light falls off otherwise with the distance.

namespace raylab::grading::local {

/// The right terms, divided by something else than the attenuation.
inline Symptom falls_by(const std::string& hint, const std::string& words, double (*divisor)(const Vec3d&, double)) {
    return each_light(hint, words, [divisor](const auto& surface, const auto& light, const auto& seen) {
        const auto [diffuse, specular] = terms_of(surface, seen);
        return light.color * (diffuse + specular) / divisor(light.attenuation, seen.distance);
    });
}

inline void add_falling_off(std::vector<Symptom>& all) {
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
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
    add(falls_by("attenuation", "the light falls off with the root of c + l d + q d^2",
                 [](const Vec3d& a, double d) { return std::sqrt(a.x + a.y * d + a.z * d * d); }));
    add(falls_by("attenuation", "the light falls off with d^2 as well",
                 [](const Vec3d& a, double d) { return (a.x + a.y * d + a.z * d * d) * d * d; }));
    add(falls_by("attenuation", "the constant coefficient is missing",
                 [](const Vec3d& a, double d) { return a.y * d + a.z * d * d; }));
    add(falls_by("attenuation", "the quadratic coefficient is missing",
                 [](const Vec3d& a, double d) { return a.x + a.y * d; }));
    add(falls_by("attenuation", "q is multiplied by 2 d, and not by d^2",
                 [](const Vec3d& a, double d) { return a.x + a.y * d + a.z * 2 * d; }));
    add(falls_by("attenuation", "the light falls off by the largest of the three summands alone",
                 [](const Vec3d& a, double d) {
                     return std::max({a.x, a.y * d, a.z * d * d});
                 }));
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
    add(each_light("attenuation", "the highlight falls off twice", [](const auto& s, const auto& l, const auto& seen) {
        const auto [diffuse, specular] = terms_of(s, seen);
        return l.color * (diffuse + specular / seen.falls) / seen.falls;
    }));
    add(each_light("attenuation", "the diffuse term falls off twice",
                   [](const auto& s, const auto& l, const auto& seen) {
                       const auto [diffuse, specular] = terms_of(s, seen);
                       return l.color * (diffuse / seen.falls + specular) / seen.falls;
                   }));
}

}  // namespace raylab::grading::local
