#include "raylab/radiosity/hierarchy/link.h"

#include "raylab/radiosity/form_factor/contour_form_factor.h"
#include "raylab/radiosity/patch_form_factors.h"

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

// How far the mean brightness of a source may mislead, as a share of the range of its brightness. The mean of a product
// differs from the product of the means by at most a quarter of both ranges (Gruess, Mathematische Zeitschrift 39,
// 1935). Over a source of radius R the kernel cos cos / (pi r^2) ranges by about 6 R / r of itself: 4 R / r by the
// distance, the rest by the cosines.
double variation_over(const Patch& source, const Patch& receiver) {
    const double apart = glm::distance(source.center, receiver.center);
    return std::min(1.0, 1.5 * std::sqrt(source.area / 2) / apart);
}

/// The form factor of a source from points of a receiver, in full view.
struct PointFactors {
    double mean, least, most;
};

// Its middle and points by its corners: the corners of a square over the middle of another see the same of it.
PointFactors point_factors(const Patch& receiver, const Patch& source) {
    const auto seen_from = [&](const Vec3d& point) {
        return contour_form_factor(point, receiver.normal, source.polygon());
    };
    constexpr double to_corner = 0.9;  // at the corner itself a source that touches it is seen edge-on
    const double middle = seen_from(receiver.center);
    PointFactors seen{middle / 2, middle, middle};
    for (const Vec3d& corner : receiver.polygon()) {
        const double factor = seen_from(glm::mix(receiver.center, corner, to_corner));
        seen.mean += factor / (2 * receiver.corner_count);
        seen.least = std::min(seen.least, factor);
        seen.most = std::max(seen.most, factor);
    }
    return seen;
}

// The shadow rays by which it is decided whether a link is refined, and others for the factor that it is kept with.
enum class RaysTo { decide, measure };

// The share of shadow rays that pass. A pair has the same ones in both directions, so that its links are reciprocal.
double open_share(const ElementTree& elements, const LinkEnds& ends, const PatchVisibility& visibility, int rays,
                  RaysTo purpose, Traversal& traversal) {
    const Element &receiver = elements[ends.receiver], &source = elements[ends.source];
    const bool in_order = receiver.number < source.number;
    const Element &a = in_order ? receiver : source, &b = in_order ? source : receiver;
    const auto shifts =
        purpose == RaysTo::decide ? shifts_of_pair(a.number, b.number) : shifts_of_pair(b.number, a.number);
    return visibility.share({a.root, a.patch}, {b.root, b.patch}, rays, shifts, traversal).share;
}

// What each quarter of a source exchanges with a receiver, per area, from the quarter's middle.
std::array<float, 4> exchanges_of_quarters(const Patch& source, const Patch& receiver) {
    std::array<float, 4> exchanges;
    float sum = 0;
    for (std::size_t i = 0; const Patch& quarter : quarters(source)) {
        exchanges[i] = static_cast<float>(contour_form_factor(quarter.center, quarter.normal, receiver.polygon()));
        sum += exchanges[i++];
    }
    return sum > 0 ? exchanges : std::array<float, 4>{1, 1, 1, 1};
}

}  // namespace

Link estimated_link(const ElementTree& elements, const LinkEnds& ends, const PatchVisibility& visibility, int rays,
                    Traversal& traversal) {
    if (visibility.nothing_hides()) rays = 0;
    const Patch &receiver = elements[ends.receiver].patch, &source = elements[ends.source].patch;
    Link link{ends.source, 0, 0, 0, 0};
    if (!face_each_other(receiver, source)) return link;
    const PointFactors seen = point_factors(receiver, source);
    if (seen.most == 0) return link;
    const double share = open_share(elements, ends, visibility, rays, RaysTo::decide, traversal);
    const bool partly_hidden = share > 0 && share < 1;
    const double hidden_bound = rays == 0 ? 0 : partly_hidden ? 1 : 1.0 / (rays + 1);
    const double variation = partly_hidden ? 1 : variation_over(source, receiver);
    link.spread = static_cast<float>(share * (seen.most - seen.least));
    link.hidden_bound = static_cast<float>(hidden_bound * seen.most);
    link.factor = share * seen.mean;
    link.variation = static_cast<float>(variation * link.factor);
    return link;
}

Link measured_link(const ElementTree& elements, const LinkEnds& ends, const Link& estimated,
                   const PatchVisibility& visibility, int rays, Traversal& traversal) {
    Link link = estimated;
    if (!link.exists()) return link;
    if (visibility.nothing_hides()) rays = 0;
    const Patch &receiver = elements[ends.receiver].patch, &source = elements[ends.source].patch;
    const double share = open_share(elements, ends, visibility, rays, RaysTo::measure, traversal);
    link.factor = share > 0 ? share * exchange_by_distance(receiver, source) / receiver.area : 0;
    if (link.factor > 0) link.of_quarters = exchanges_of_quarters(source, receiver);
    return link;
}

}  // namespace raylab
