#pragma once

#include "sanitized.h"

#include "raylab/base/tiles.h"
#include "raylab/experiment/adversarial/adversarial.h"
#include "raylab/geometry/intersect/intersect.h"
#include "raylab/geometry/oracle/oracle.h"

#include <fmt/format.h>

#include <functional>
#include <mutex>
#include <optional>
#include <string>

// The lab's answers, judged by the oracle.

namespace raylab::adversarial {

inline std::string words(const Vec3f& v) { return fmt::format("({:a}, {:a}, {:a})", v.x, v.y, v.z); }

inline std::string words(const Ray& ray) {
    return fmt::format("from {} along {} in [{:a}, {:a}]{}", words(ray.origin), words(ray.direction), ray.range.min,
                       ray.range.max, ray.time == 0 ? "" : fmt::format(" at time {:a}", ray.time));
}

/// True if two structures give the same answer, to the bit.
inline bool same(const std::optional<Hit>& a, const std::optional<Hit>& b) {
    if (!a || !b) return !a && !b;
    return a->primitive == b->primitive && a->t == b->t && a->u == b->u && a->v == b->v && a->part == b->part;
}

/// The fault of an answer; absent: none.
inline std::optional<std::string> fault(const Ray& ray, const oracle::Answer& truth,
                                        const std::optional<Candidate>& given) {
    if (given.has_value() != truth.hit()) {
        return fmt::format("{} where there is {}: {}", given ? "a hit" : "a miss", truth.hit() ? "a hit" : "a miss",
                           words(ray));
    }
    if (!given) return std::nullopt;
    const bool enclosed =
        is_lteq(truth.t->compare(given->t + given->t_error)) && is_gteq(truth.t->compare(given->t - given->t_error));
    if (!enclosed)
        return fmt::format("t = {:a} +- {:a} is not {}: {}", given->t, given->t_error, truth.t->to_string(),
                           words(ray));
    // So close to the exact t that the float nearest to it is within one float; of t near the smallest float, ask.
    if (given->t_error <= 0x1p-26 * std::abs(given->t) && std::abs(given->t) > std::numeric_limits<float>::min())
        return std::nullopt;
    const float t = cast<float>(given->t);
    if (std::isinf(t) || truth.t->error_in_ulp(t) <= 1) return std::nullopt;
    return fmt::format("t = {:a} is {} floats off: {}", t, truth.t->error_in_ulp(t), words(ray));
}

inline std::optional<std::string> fault(const Ray& ray, const Triangle& t, const std::optional<Candidate>& given) {
    const TriangleOf<double> triangle{convert<double>(t.a), convert<double>(t.b), convert<double>(t.c)};
    auto wrong = fault(ray, oracle::intersect(in<double>(ray), triangle), given);
    if (wrong) *wrong += fmt::format(" at {} {} {}", words(t.a), words(t.b), words(t.c));
    return wrong;
}

inline std::optional<std::string> fault(const Ray& ray, const Sphere& s, const std::optional<Candidate>& given) {
    const SphereOf<double> sphere{convert<double>(s.center), s.radius};
    auto wrong = fault(ray, oracle::intersect(in<double>(ray), sphere), given);
    if (wrong) *wrong += fmt::format(" at {} {:a}", words(s.center), s.radius);
    return wrong;
}

/// The fault of the answer; half the time, where there is a hit, of the answer in a range that ends about it instead.
template <class Shape>
std::optional<std::string> fault_in_ranges(Draw& draw, Ray ray, const Shape& shape) {
    DecisionCounts decisions;
    const auto first = intersect(ray, shape, decisions);
    if (auto wrong = fault(ray, shape, first)) return wrong;
    if (!first || draw.one_in(2)) return std::nullopt;
    ray.range = tight_range(draw, cast<float>(first->t));
    return fault(ray, shape, intersect(ray, shape, decisions));
}

/// The number of `count` rays that a build asks: all, but one in fifty where a sanitizer watches. The million rays are
/// for the decisions.
inline std::size_t watched(std::size_t count) { return is_sanitized ? count / 50 : count; }

/// Judges `count` cases on all cores. Empty: none wrong; else how many, and the first.
inline std::string faults(std::size_t count, const std::function<std::optional<std::string>(Draw&)>& judge) {
    count = watched(count);
    std::mutex collecting;
    std::size_t wrong = 0;
    std::string first;
    for_each_piece(count, 1000, 0, [&](std::size_t begin, std::size_t end) {
        Draw draw(begin);
        for (std::size_t i = begin; i < end; ++i) {
            const auto found = judge(draw);
            if (!found) continue;
            const std::lock_guard lock(collecting);
            if (wrong++ == 0) first = *found;
        }
    });
    return wrong == 0 ? "" : fmt::format("{} of {} wrong, such as {}", wrong, count, first);
}

}  // namespace raylab::adversarial
