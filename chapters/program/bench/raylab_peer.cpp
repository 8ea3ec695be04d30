#include "peer.h"

#include "raylab/accelerator/accelerator.h"

namespace raylab::bench {

namespace {

class RaylabPeer final : public Peer {
public:
    RaylabPeer(const std::string& name, const Scene& scene, int threads)
        : accelerator_(make_accelerator(name, scene, {.threads = threads})) {}

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

PeerKind raylab_peer(const std::string& accelerator) {
    return {accelerator, [accelerator](int threads) -> Build {
                return [accelerator, threads](const Scene& scene) {
                    return std::make_unique<RaylabPeer>(accelerator, scene, threads);
                };
            }};
}

}  // namespace raylab::bench
