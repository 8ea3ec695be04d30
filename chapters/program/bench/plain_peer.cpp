#include "peer.h"

#include "raylab/accelerator/bvh8/bvh8.h"

namespace raylab::bench {

namespace {

// A structure as the exact ones are, so that both are asked by the same calls.
class Bvh8InFloats final : public Accelerator {
public:
    explicit Bvh8InFloats(const Scene& scene) : tree_(scene) {}

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override {
        return tree_.closest_in_floats(ray, traversal);
    }
    bool occluded(const Ray& ray, Traversal& traversal) const override { return closest(ray, traversal).has_value(); }
    std::size_t bytes() const override { return tree_.bytes(); }

private:
    Bvh8 tree_;
};

}  // namespace

PeerKind plain_peer(const OtherPeer& peer) {
    return {std::string(peer.name), [](int) -> Build {
                return [](const Scene& scene) { return peer_of(std::make_unique<Bvh8InFloats>(scene)); };
            }};
}

}  // namespace raylab::bench
