#pragma once

#include "geometry/verdict.h"

#include "raylab/geometry/predicate/intersection.h"

namespace raylab::adversarial {

/// The fault of what a filter that has decided says of a shape at rest: by the oracle, and by the part and the bits of
/// t that the whole question has.
template <class S>
std::optional<std::string> filter_fault(const Ray& ray, const S& shape, Sides sides,
                                        const std::optional<Candidate>& given) {
    if (auto wrong = fault(ray, oracle::intersect(in<double>(ray), Shape(shape), {}, sides), given)) return wrong;
    if (!given) return std::nullopt;
    Signs<Estimate> signs;
    const auto general = intersect(transformed_ray<Estimate>(ray, {}), shape, sides, signs);
    if (signs.undecided()) return std::nullopt;
    const bool same = general && value(general->t).middle() == given->t && general->part == given->part;
    return same ? std::nullopt : std::optional("not the general answer: " + words(ray));
}

}  // namespace raylab::adversarial
