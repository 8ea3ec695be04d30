#include "peer.h"

#include "raylab/accelerator/bvh8/bvh8.h"

namespace raylab::bench {

namespace {

class PlainPeer final : public Peer {
public:
    explicit PlainPeer(const Scene& scene) : tree_(scene) {}

    void closest(std::span<const Ray> rays, std::span<std::int32_t> triangles) const override {
        Traversal traversal;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const auto hit = tree_.closest_in_floats(rays[i], traversal);
            triangles[i] = hit ? static_cast<std::int32_t>(hit->primitive.part) : none;
        }
    }

    void any(std::span<const Ray> rays, std::span<std::int32_t> triangles) const override {
        Traversal traversal;
        for (std::size_t i = 0; i < rays.size(); ++i)
            triangles[i] = tree_.closest_in_floats(rays[i], traversal) ? 0 : none;
    }

    std::size_t bytes() const override { return tree_.bytes(); }

private:
    Bvh8 tree_;
};

}  // namespace

PeerKind plain_peer(const OtherPeer& peer) {
    return {std::string(peer.name),
            [](int) -> Build { return [](const Scene& scene) { return std::make_unique<PlainPeer>(scene); }; }};
}

}  // namespace raylab::bench
