#pragma once

#include "options.h"

#include "raylab/accelerator/accelerator.h"
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

/// The number that means that no triangle is hit.
inline constexpr std::int32_t none = -1;

/// A structure over one mesh, of raylab or of another library. Several threads query it at once.
class Peer {
public:
    virtual ~Peer() = default;
    virtual void closest(std::span<const Ray> rays,
                         std::span<std::int32_t> triangles) const = 0;                         // the nearest, or none
    virtual void any(std::span<const Ray> rays, std::span<std::int32_t> triangles) const = 0;  // 0 for a hit, or none
    // Absent where the peer does not count.
    virtual std::optional<Traversal> counts(std::span<const Ray>, RayQuestion) const { return {}; }
    virtual std::size_t bytes() const = 0;  // what is allocated beyond the shared vertices and indices
};

/// Builds the structure over a scene of one mesh, with as many threads as it can use up to the wanted number. The
/// mesh's last vertex must be readable four bytes beyond its end, because Embree requires that.
using Build = std::function<std::unique_ptr<Peer>(const Scene& scene)>;

/// A peer's name, and how it is set up for a number of threads.
struct PeerKind {
    std::string name;
    std::function<Build(int threads)> builder;
    // What it is set up for, or the most that any such peer of the process is set up for.
    enum class Threads { of_its_own, of_the_process } threads = Threads::of_its_own;
};

/// The peer of that name. An Error lists the known peers: raylab's structures, and the other libraries with which this
/// program was built.
PeerKind peer_kind(const std::string& name);

/// The peers that are missing in this program, and how to get them, one on each line.
std::vector<std::string> missing_peers();

/// The names of the peers of other libraries that this program was built with.
std::vector<std::string> foreign_peers();

/// A structure as a peer.
std::unique_ptr<Peer> peer_of(std::unique_ptr<Accelerator> accelerator);

/// One of raylab's structures, by the name that make_accelerator() knows.
PeerKind raylab_peer(const std::string& accelerator);

/// raylab's bvh8, with Pluecker's test in floats alone deciding, as fast peers do. The difference to
/// the exact tree, which is asked by the same calls, is the cost of exact decisions. It is for closest hits: it has no
/// other query, and uses that one where any hit would do.
PeerKind plain_peer(const OtherPeer& peer);

/// Embree's default test, or the one that is more accurate at edges (its robust flag); and its usual build, or its
/// build of high quality, which splits triangles (Embree takes the usual one for robust tests in any case).
enum class EmbreeKind { robust, by_default, high };
PeerKind embree_peer(const OtherPeer& peer, EmbreeKind kind);

/// CGAL's AABB_tree: exact hit decisions, for rays that start at t = 0.
PeerKind cgal_peer(const OtherPeer& peer);

}  // namespace raylab::bench
