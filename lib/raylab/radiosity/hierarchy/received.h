#pragma once

#include "raylab/base/tiles.h"
#include "raylab/radiosity/hierarchy/link.h"

#include <vector>

namespace raylab {

/// The links of each element as a receiver.
using Links = std::vector<std::vector<Link>>;

/// The sum of value(receiver, link) over the links of each element and of all elements above it, so that at a leaf it
/// holds for everything that arrives there: each element gathers, and what it has is pushed down. Where elements are
/// partly closed, more of it goes to what is open (open_areas()).
template <class Value, class Of>
std::vector<Value> received(const ElementTree& elements, const Links& links, const std::vector<double>& open,
                            int threads, const Of& value) {
    std::vector<Value> sum(elements.size(), Value(0));
    for_each_piece(elements.size(), 256, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            for (const Link& link : links[i]) sum[i] += value(static_cast<std::uint32_t>(i), link);
    });
    for (std::size_t i = elements.roots(); i < elements.size(); ++i) {
        const std::uint32_t parent = elements[i].parent;
        if (open[parent] == 0) continue;
        const double per_area = elements[parent].patch.area / elements[i].patch.area;
        sum[i] += open[i] / open[parent] * per_area * sum[parent];
    }
    return sum;
}

}  // namespace raylab
