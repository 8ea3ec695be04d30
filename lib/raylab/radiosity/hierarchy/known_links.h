#pragma once

#include "raylab/radiosity/hierarchy/link.h"

#include <cstddef>
#include <optional>
#include <unordered_map>
#include <vector>

namespace raylab {

/// Links that were estimated before, in whatever light: they depend on the two elements, on what hides them from each
/// other and on the number of shadow rays alone. Light only decides which of them are asked for.
class KnownLinks {
public:
    /// Two elements by their numbers, which do not depend on the order in which elements are made.
    struct Pair {
        std::uint64_t receiver, source;
        bool operator==(const Pair&) const = default;
    };
    struct Known {
        Link estimate;
        std::optional<Link> measured;  // measured_link(), if it was asked for
    };
    struct Entry {
        Pair pair;
        Known known;
    };

    const Known* find(const Pair& pair) const;
    void add(const Pair& pair, const Known& known) { known_.insert_or_assign(pair, known); }

    std::size_t size() const { return known_.size(); }
    std::vector<Entry> sorted() const;

    static constexpr std::size_t bytes_each = 2 * sizeof(Entry);  // with what a hash table takes

private:
    struct Hash {
        std::size_t operator()(const Pair& pair) const { return pair.receiver * 0x9E3779B97F4A7C15u + pair.source; }
    };
    std::unordered_map<Pair, Known, Hash> known_ = {};
};

}  // namespace raylab
