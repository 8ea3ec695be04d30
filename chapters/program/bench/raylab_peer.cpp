#include "peer.h"

#include <utility>

namespace raylab::bench {

namespace {

class RaylabPeer final : public Peer {
public:
    explicit RaylabPeer(std::unique_ptr<Accelerator> accelerator) : accelerator_(std::move(accelerator)) {}

    void closest(std::span<const Ray> rays, std::span<std::int32_t> triangles) const override {
        Traversal traversal;
        closest(rays, triangles, traversal);
    }

    void any(std::span<const Ray> rays, std::span<std::int32_t> triangles) const override {
        Traversal traversal;
        any(rays, triangles, traversal);
    }

    std::optional<Traversal> counts(std::span<const Ray> rays, RayQuestion question) const override {
        std::vector<std::int32_t> triangles(rays.size());
        Traversal traversal;
        if (question == RayQuestion::any)
            any(rays, triangles, traversal);
        else
            closest(rays, triangles, traversal);
        return traversal;
    }

    std::size_t bytes() const override { return accelerator_->bytes(); }

private:
    void closest(std::span<const Ray> rays, std::span<std::int32_t> triangles, Traversal& traversal) const {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const auto hit = accelerator_->closest(rays[i], traversal);
            triangles[i] = hit ? static_cast<std::int32_t>(hit->primitive.part) : none;
        }
    }

    void any(std::span<const Ray> rays, std::span<std::int32_t> triangles, Traversal& traversal) const {
        for (std::size_t i = 0; i < rays.size(); ++i)
            triangles[i] = accelerator_->occluded(rays[i], traversal) ? 0 : none;
    }

    std::unique_ptr<Accelerator> accelerator_;
};

}  // namespace

std::unique_ptr<Peer> peer_of(std::unique_ptr<Accelerator> accelerator) {
    return std::make_unique<RaylabPeer>(std::move(accelerator));
}

PeerKind raylab_peer(const std::string& accelerator) {
    return {accelerator, [accelerator](int threads) -> Build {
                return [accelerator, threads](const Scene& scene) {
                    return peer_of(make_accelerator(accelerator, scene, {.threads = threads}));
                };
            }};
}

}  // namespace raylab::bench
