#include "peer.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/base/error.h"

#include <algorithm>

namespace raylab::bench {

namespace {

// The peers beside the library's structures that this program was built with.
std::vector<PeerKind> built_peers() {
    std::vector<PeerKind> kinds;
#ifdef RAYLAB_BENCH_EMBREE
    kinds.push_back(embree_peer(other_peer::embree_robust, EmbreeKind::robust));
    kinds.push_back(embree_peer(other_peer::embree_default, EmbreeKind::by_default));
    kinds.push_back(embree_peer(other_peer::embree_high, EmbreeKind::high));
#endif
#ifdef RAYLAB_BENCH_CGAL
    kinds.push_back(cgal_peer(other_peer::cgal));
#endif
    kinds.push_back(plain_peer(other_peer::bvh8_plain));
    return kinds;
}

std::optional<PeerKind> built_peer(std::string_view name) {
    for (const PeerKind& kind : built_peers())
        if (kind.name == name) return kind;
    return std::nullopt;
}

}  // namespace

std::vector<std::string> foreign_peers() {
    std::vector<std::string> names;
    for (const OtherPeer& peer : other_peer::all)
        if (!peer.needs.empty() && built_peer(peer.name)) names.emplace_back(peer.name);
    return names;
}

std::vector<std::string> missing_peers() {
    std::vector<std::string> missing;
    for (const OtherPeer& peer : other_peer::all)
        if (!built_peer(peer.name) && std::ranges::find(missing, peer.needs) == missing.end())
            missing.emplace_back(peer.needs);
    return missing;
}

PeerKind peer_kind(const std::string& name) {
    if (auto built = built_peer(name)) return *built;
    const auto ours = accelerator_names();
    const auto stem = name.substr(0, name.find(':'));  // "grid:10": make_accelerator() checks what follows the colon
    if (std::ranges::find(ours, stem) != ours.end()) return raylab_peer(name);
    std::string known;
    for (const PeerKind& kind : built_peers()) known += kind.name + ", ";
    throw Error("expected a peer (" + known + accelerator_list() + "), found \"" + name + "\"");
}

}  // namespace raylab::bench
