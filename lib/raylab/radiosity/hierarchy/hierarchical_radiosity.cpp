#include "raylab/radiosity/hierarchy/hierarchical_radiosity.h"

#include "raylab/base/error.h"
#include "raylab/radiosity/hierarchy/linked_elements.h"
#include "raylab/radiosity/scene_system.h"

#include <fmt/format.h>

#include <utility>

namespace raylab {

namespace {

void check_options(const HierarchyOptions& options) {
    if (!(options.error > 0)) throw Error(fmt::format("expected an error of links over 0, found {}", options.error));
    if (!(options.smallest > 0))
        throw Error(fmt::format("expected a length over 0 for the smallest element, found {}", options.smallest));
}

// The mean radiosity of a source as a link's receiver sees it.
Color seen_radiosity(const ElementTree& elements, const Link& link, const std::vector<double>& open,
                     const Radiosities& radiosity) {
    const Element& source = elements[link.source];
    if (source.is_leaf()) return radiosity[link.source];
    Color sum(0);
    double weights = 0;
    for (std::uint32_t i = 0; i < 4; ++i) {
        const double weight = open[source.first_child + i] * link.of_quarters[i];
        sum += weight * radiosity[source.first_child + i];
        weights += weight;
    }
    return weights > 0 ? sum / weights : radiosity[link.source];
}

}  // namespace

std::vector<Color> gathered_light(const ElementTree& elements, const Links& links, const std::vector<double>& open,
                                  const Radiosities& radiosity, int threads) {
    return received<Color>(elements, links, open, threads, [&](std::uint32_t, const Link& link) {
        return link.factor * seen_radiosity(elements, link, open, radiosity);
    });
}

HierarchicalRadiosity hierarchical_radiosity(const PatchMesh& mesh, const PatchVisibility& visibility,
                                             const HierarchyOptions& options) {
    check_options(options);
    LinkedElements linked(mesh, visibility, options);
    if (!(linked.allowed() > 0)) throw no_light(mesh.model.scene);
    // Links that a loose error has refined show where the light is; most pairs are never looked at with the tight one.
    constexpr double looser = 4;
    constexpr double while_coarse = 1e-3;  // more would be solved for nothing
    linked.link_roots(looser * looser);
    linked.solve(while_coarse);
    linked.refine(looser);
    linked.solve(while_coarse);
    // Quarters have other brightnesses than the whole had: until no link is found wrong.
    constexpr int most_rounds = 16;
    for (int round = 0; round < most_rounds && linked.refine(1); ++round) linked.solve(while_coarse);
    linked.solve(options.residual);
    return std::move(linked).result();
}

}  // namespace raylab
