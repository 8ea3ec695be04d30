#include "peer.h"

#include "raylab/accelerator/accelerator.h"

namespace raylab::bench {

namespace {

class RaylabPeer final : public Peer {
public:
    RaylabPeer(const std::string& name, const Scene& scene) : accelerator_(make_accelerator(name, scene)) {}

    void closest(std::span<const Ray> rays, std::span<std::int32_t> triangles) const override {
        Traversal traversal;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const auto hit = accelerator_->closest(rays[i], traversal);
            triangles[i] = hit ? static_cast<std::int32_t>(hit->primitive.part) : none;
        }
    }

    void any(std::span<const Ray> rays, std::span<std::int32_t> triangles) const override {
        Traversal traversal;
        for (std::size_t i = 0; i < rays.size(); ++i) triangles[i] = accelerator_->occluded(rays[i], traversal) ? 0 : none;
    }

    std::size_t bytes() const override { return accelerator_->bytes(); }

private:
    std::unique_ptr<Accelerator> accelerator_;
};

}  // namespace

PeerKind raylab_peer(const std::string& accelerator) {
    return {accelerator, [accelerator](int) -> Build {
                return [accelerator](const Scene& scene) { return std::make_unique<RaylabPeer>(accelerator, scene); };
            }};
}

}  // namespace raylab::bench
