#pragma once

#include "raylab/accelerator/trace_rays.h"
#include "raylab/geometry/ray.h"
#include "raylab/scene/scene.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace raylab::bench {

/// No triangle is hit.
inline constexpr std::int32_t none = -1;

/// One structure over one mesh, whoever made it. What it is asked, it is asked from several threads at once.
class Peer {
public:
    virtual ~Peer() = default;
    virtual void closest(std::span<const Ray> rays,
                         std::span<std::int32_t> triangles) const = 0;                         // the nearest, or none
    virtual void any(std::span<const Ray> rays, std::span<std::int32_t> triangles) const = 0;  // 0, or none
    virtual std::optional<Traversal> counts(std::span<const Ray>, RayQuestion) const { return {}; }  // if it counts
    virtual std::size_t bytes() const = 0;  // allocated beyond the shared vertices and indices
};

/// Builds the structure over a scene of one mesh, with as many threads as it can use up to the wanted number. The
/// mesh's last vertex can be read four bytes beyond its end, as Embree wants.
using Build = std::function<std::unique_ptr<Peer>(const Scene& scene)>;

/// What a peer is called, and how it is set up for a number of threads.
struct PeerKind {
    std::string name;
    std::function<Build(int threads)> builder;
};

/// Error names the known peers: raylab's structures, and the foreign ones that this program was built with.
PeerKind peer_kind(const std::string& name);

/// The peers that are missing here, and what would bring them; a line each.
std::vector<std::string> missing_peers();

/// The names of the foreign peers that are here.
std::vector<std::string> foreign_peers();

/// One of ours, by the name that make_accelerator() knows.
PeerKind raylab_peer(const std::string& accelerator);

/// "wide_plain": our wide tree with Pluecker's test in floats deciding alone, as fast peers have it. What exact decisions
/// cost is seen beside it, for closest hits (it knows no other question, and answers that one where any hit would do).
PeerKind plain_peer();

/// Embree's own choice among its tests, or the one that is tighter at edges (its robust flag).
enum class EmbreeTests { by_default, robust };
PeerKind embree_peer(const std::string& name, EmbreeTests tests);

/// CGAL's AABB_tree: exact hit decisions, for rays that start at t = 0.
PeerKind cgal_peer(const std::string& name);

}  // namespace raylab::bench
