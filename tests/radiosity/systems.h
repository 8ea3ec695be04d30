#pragma once

#include "raylab/radiosity/radiosity_system.h"
#include "raylab/sampling/sequence.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

// Systems whose form factors are known, and one solver that shares nothing with the library's.

namespace raylab {

/// All patches reflect alike, and none emits.
inline RadiositySystem dark_system(std::vector<double> area, double reflectance, FormFactors form_factors) {
    const std::size_t n = area.size();
    return {std::move(area), std::vector<Color>(n, Color(0)), std::vector<Color>(n, Color(reflectance)),
            std::move(form_factors)};
}

/// A unit cube from inside: a patch a face, opposite faces are neighbours in the list, face 0 emits 1 in each channel.
inline RadiositySystem cube(double reflectance) {
    constexpr double opposite = .199824895698387;
    constexpr double perpendicular = .200043776075403;
    FormFactors form_factors(6);
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j)
            form_factors.at(i, j) = i == j ? 0 : i / 2 == j / 2 ? opposite : perpendicular;
    RadiositySystem system = dark_system(std::vector<double>(6, 1.0), reflectance, std::move(form_factors));
    system.emission[0] = Color(1);
    return system;
}

/// Patches of any shape that tile one sphere from inside: F_ij is patch j's share of the area, exactly.
inline RadiositySystem sphere(const std::vector<double>& area, double reflectance) {
    double all = 0;
    for (const double a : area) all += a;
    FormFactors form_factors(area.size());
    for (std::size_t i = 0; i < area.size(); ++i)
        for (std::size_t j = 0; j < area.size(); ++j) form_factors.at(i, j) = area[j] / all;
    return dark_system(area, reflectance, std::move(form_factors));
}

inline RadiositySystem with_form_factors_times(RadiositySystem system, double factor) {
    for (std::size_t i = 0; i < system.patches(); ++i)
        for (double& f : system.form_factors.row(i)) f *= factor;
    return system;
}

inline Color any_color(RandomSequence& random, double low, double high) {
    const double r = random.between(low, high);  // one at a time, because the compiler chooses the order of arguments
    const double g = random.between(low, high);
    return {r, g, random.between(low, high)};
}

/// Any system with reciprocity: of the patches some see themselves, some emit, some are black in one channel or in all,
/// and a row sums to at most `largest_row`.
inline RadiositySystem any_system(std::size_t patches, double largest_row, std::uint64_t seed) {
    RandomSequence random(seed, patches);
    std::vector<double> area;
    for (std::size_t i = 0; i < patches; ++i) area.push_back(random.between(0.1, 4));
    FormFactors form_factors(patches);
    for (std::size_t i = 0; i < patches; ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            const double exchange = random.next() < 0.3 ? 0 : random.next();
            form_factors.at(i, j) = exchange * area[j];
            form_factors.at(j, i) = exchange * area[i];
        }
    double largest = 0;
    for (std::size_t i = 0; i < patches; ++i) {
        double sum = 0;
        for (const double f : form_factors.row(i)) sum += f;
        largest = std::max(largest, sum);
    }
    RadiositySystem system = dark_system(std::move(area), 0, std::move(form_factors));
    for (std::size_t i = 0; i < patches; ++i) {
        system.reflectance[i] = random.next() < 0.1 ? Color(0) : any_color(random, 0, 0.95);
        if (random.next() < 0.1) system.reflectance[i].g = 0;
        if (random.next() < 0.3) system.emission[i] = any_color(random, 0, 5);
    }
    return largest > 0 ? with_form_factors_times(std::move(system), largest_row / largest) : system;
}

/// The solution by plain elimination without pivots, which a matrix with a dominant diagonal does not need, in long
/// doubles.
inline Radiosities true_radiosities(const RadiositySystem& system) {
    const std::size_t n = system.patches();
    Radiosities radiosity(n);
    for (int channel = 0; channel < 3; ++channel) {
        std::vector<std::vector<long double>> rows(n, std::vector<long double>(n + 1));
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j)
                rows[i][j] = (i == j ? 1.0L : 0.0L) -
                             static_cast<long double>(system.reflectance[i][channel]) * system.form_factors.at(i, j);
            rows[i][n] = system.emission[i][channel];
        }
        for (std::size_t pivot = 0; pivot < n; ++pivot)
            for (std::size_t i = 0; i < n; ++i) {
                if (i == pivot) continue;
                const long double factor = rows[i][pivot] / rows[pivot][pivot];
                for (std::size_t j = pivot; j <= n; ++j) rows[i][j] -= factor * rows[pivot][j];
            }
        for (std::size_t i = 0; i < n; ++i) radiosity[i][channel] = static_cast<double>(rows[i][n] / rows[i][i]);
    }
    return radiosity;
}

/// The largest difference of any patch and channel over the largest value of that channel.
inline double relative_error(const Radiosities& radiosity, const Radiosities& truth) {
    Color largest(0);
    for (const Color& b : truth) largest = glm::max(largest, glm::abs(b));
    double error = 0;
    for (std::size_t i = 0; i < truth.size(); ++i)
        for (int channel = 0; channel < 3; ++channel) {
            const double apart = std::abs(radiosity[i][channel] - truth[i][channel]);
            if (apart > 0) error = std::max(error, apart / largest[channel]);
        }
    return error;
}

}  // namespace raylab
