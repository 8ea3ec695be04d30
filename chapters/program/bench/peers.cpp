#include "peer.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/base/error.h"

#include <algorithm>

namespace raylab::bench {

namespace {

std::vector<PeerKind> foreign() {
    std::vector<PeerKind> kinds;
#ifdef RAYLAB_BENCH_EMBREE
    kinds.push_back(embree_peer("embree_robust", EmbreeTests::robust));
    kinds.push_back(embree_peer("embree_default", EmbreeTests::by_default));
#endif
#ifdef RAYLAB_BENCH_CGAL
    kinds.push_back(cgal_peer("cgal"));
#endif
    return kinds;
}

}  // namespace

std::vector<std::string> foreign_peers() {
    std::vector<std::string> names;
    for (const PeerKind& kind : foreign()) names.push_back(kind.name);
    return names;
}

std::vector<std::string> missing_peers() {
    std::vector<std::string> missing;
#ifndef RAYLAB_BENCH_EMBREE
    missing.push_back("Embree (Debian: libembree-dev)");
#endif
#ifndef RAYLAB_BENCH_CGAL
    missing.push_back("CGAL's AABB_tree (Debian: libcgal-dev)");
#endif
    return missing;
}

PeerKind peer_kind(const std::string& name) {
    for (const PeerKind& kind : foreign())
        if (kind.name == name) return kind;
    if (name == plain_peer().name) return plain_peer();
    const auto ours = accelerator_names();
    const auto stem = name.substr(0, name.find(':'));  // "grid:10": make_accelerator() checks what follows the colon
    if (std::ranges::find(ours, stem) != ours.end()) return raylab_peer(name);
    std::string known;
    for (const std::string& peer : foreign_peers()) known += peer + ", ";
    known += plain_peer().name + ", ";
    throw Error("expected a peer (" + known + accelerator_list() + "), found \"" + name + "\"");
}

}  // namespace raylab::bench
