#include "raylab/radiosity/hierarchy/known_links.h"

#include <algorithm>
#include <tuple>

namespace raylab {

const KnownLinks::Known* KnownLinks::find(const Pair& pair) const {
    const auto found = known_.find(pair);
    return found == known_.end() ? nullptr : &found->second;
}

std::vector<KnownLinks::Entry> KnownLinks::sorted() const {
    std::vector<Entry> entries;
    for (const auto& [pair, known] : known_) entries.push_back({pair, known});
    std::ranges::sort(entries, {}, [](const Entry& e) { return std::tuple(e.pair.receiver, e.pair.source); });
    return entries;
}

}  // namespace raylab
