// Embree 3 as its manual recommends for single rays: medium or high quality, the device's defaults except for the
// number of threads, shared vertex and index buffers. Subnormal numbers are not flushed to zero, as in the lab's own
// code.

#include "embree_ray.h"
#include "embree_triangles.h"
#include "peer.h"

#include "raylab/base/error.h"

#include <embree3/rtcore.h>

#include <atomic>

namespace raylab::bench {

namespace {

/// A device, and the number of bytes that its scenes hold.
class Device {
public:
    explicit Device(int threads) : device_(rtcNewDevice(("threads=" + std::to_string(threads)).c_str())) {
        if (!device_)
            throw Error("Embree: expected a device, found error " + std::to_string(rtcGetDeviceError(nullptr)));
        rtcSetDeviceMemoryMonitorFunction(device_, count, this);
    }
    ~Device() { rtcReleaseDevice(device_); }
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    RTCDevice get() const { return device_; }
    std::int64_t bytes() const { return bytes_; }

private:
    static bool count(void* self, ssize_t bytes, bool) {
        static_cast<Device*>(self)->bytes_ += bytes;
        return true;
    }

    std::atomic<std::int64_t> bytes_ = 0;
    RTCDevice device_;
};

class EmbreePeer final : public Peer {
public:
    EmbreePeer(std::shared_ptr<Device> device, EmbreeKind kind, const Mesh& mesh)
        : device_(std::move(device)), before_(device_->bytes()), scene_(rtcNewScene(device_->get())) {
        if (kind == EmbreeKind::robust) rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        rtcSetSceneBuildQuality(scene_, kind == EmbreeKind::high ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_MEDIUM);
        add_triangles(device_->get(), scene_, mesh);
        rtcCommitScene(scene_);
        bytes_ = static_cast<std::size_t>(device_->bytes() - before_);
    }
    ~EmbreePeer() override { rtcReleaseScene(scene_); }
    EmbreePeer(const EmbreePeer&) = delete;
    EmbreePeer& operator=(const EmbreePeer&) = delete;

    void closest(std::span<const Ray> rays, std::span<std::int32_t> triangles) const override {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            RTCRayHit hit{.ray = in_embree(rays[i]), .hit = {}};
            hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(scene_, &context, &hit);
            triangles[i] = hit.hit.geomID == RTC_INVALID_GEOMETRY_ID ? none : static_cast<std::int32_t>(hit.hit.primID);
        }
    }

    void any(std::span<const Ray> rays, std::span<std::int32_t> triangles) const override {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            RTCRay ray = in_embree(rays[i]);
            rtcOccluded1(scene_, &context, &ray);
            triangles[i] = ray.tfar < 0 ? 0 : none;  // -infinity means that something was hit
        }
    }

    std::size_t bytes() const override { return bytes_; }

private:
    std::shared_ptr<Device> device_;
    std::int64_t before_;
    RTCScene scene_;
    std::size_t bytes_ = 0;
};

}  // namespace

PeerKind embree_peer(const OtherPeer& peer, EmbreeKind kind) {
    const auto builder = [kind](int threads) -> Build {
        return [kind, device = std::make_shared<Device>(threads)](const Scene& scene) {
            const auto& mesh = std::get<std::shared_ptr<const Mesh>>(scene.objects.at(0).shape);
            return std::make_unique<EmbreePeer>(device, kind, *mesh);
        };
    };
    // As soon as one device may use two threads, all of them build with two.
    return {std::string(peer.name), builder, PeerKind::Threads::of_the_process};
}

}  // namespace raylab::bench
