// bench_many [SPHERES] [INSTANCES] [RAYS]: a scene of very many spheres, and one of very many instances of a mesh,
// asked by bvh8 and by Embree in one run, on one thread: rays a second of processor time, bytes, build time, and how
// often the two disagree.

#include "embree_ray.h"
#include "embree_triangles.h"

#include "bench/seconds_of.h"
#include "raylab/accelerator/accelerator.h"
#include "raylab/base/heap.h"
#include "raylab/experiment/adversarial/adversarial.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/experiment/measure/quantile.h"
#include "raylab/scene/scene.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <cstdlib>
#include <functional>
#include <memory>
#include <vector>

using namespace raylab;
using raylab::bench::in_embree;

namespace {

double seconds_of(const std::function<void()>& work) { return bench::seconds_of(CLOCK_PROCESS_CPUTIME_ID, work); }

// The scenes fill a cube about the origin whose half side is 1.

Scene spheres(int count) {
    adversarial::Draw draw(1);
    const float radius = 0.6f / cast<float>(std::cbrt(count));
    Scene scene;
    for (int i = 0; i < count; ++i)
        scene.objects.push_back({.shape = Sphere{draw.in_cube(1), radius * draw.uniform(0.5f, 1)}});
    return scene;
}

Scene instances(int count) {
    adversarial::Draw draw(2);
    const auto mesh = std::make_shared<const Mesh>(bumpy_sphere(4));
    const double size = 0.6 / std::cbrt(count);
    Scene scene;
    for (int i = 0; i < count; ++i) {
        const double scale = size * draw.number(0.5, 1);
        const auto place = AffineSteps::scale({scale, scale * draw.number(0.5, 1), scale})
                               .then(AffineSteps::rotate(convert<double>(draw.in_cube(1)), draw.number(0, 360)))
                               .then(AffineSteps::translate(convert<double>(draw.in_cube(1))));
        scene.objects.push_back({.shape = mesh, .placement = place.rounded()});
    }
    return scene;
}

std::vector<Ray> rays_in(int count) {
    adversarial::Draw draw(3);
    std::vector<Ray> rays;
    while (std::ssize(rays) < count) rays.push_back({draw.in_cube(1.2), draw.in_cube(1)});
    return rays;
}

class Embree {
public:
    explicit Embree(const Scene& scene) : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
        rtcSetDeviceMemoryMonitorFunction(
            device_,
            [](void* self, ssize_t more, bool) {
                static_cast<Embree*>(self)->bytes += more;
                return true;
            },
            this);
        if (std::holds_alternative<Sphere>(scene.objects[0].shape))
            add_spheres(scene);
        else
            add_instances(scene);
        rtcCommitScene(scene_);
    }
    ~Embree() {
        rtcReleaseScene(scene_);
        if (mesh_) rtcReleaseScene(mesh_);
        rtcReleaseDevice(device_);
    }
    Embree(const Embree&) = delete;
    Embree& operator=(const Embree&) = delete;

    std::int64_t closest(const Ray& ray) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit hit{.ray = in_embree(ray), .hit = {}};
        hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene_, &context, &hit);
        if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return -1;
        return std::int64_t{mesh_ ? hit.hit.instID[0] : hit.hit.primID};
    }
    bool any(const Ray& ray) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRay in = in_embree(ray);
        rtcOccluded1(scene_, &context, &in);
        return in.tfar < 0;
    }

    std::int64_t bytes = 0;

private:
    void attach(RTCScene to, RTCGeometry geometry) {
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(to, geometry);
        rtcReleaseGeometry(geometry);
    }

    void add_spheres(const Scene& scene) {
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_SPHERE_POINT);
        auto* of = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                                               4 * sizeof(float), scene.objects.size()));
        for (const Object& object : scene.objects) {
            const auto& sphere = std::get<Sphere>(object.shape);
            for (int axis = 0; axis < 3; ++axis) *of++ = sphere.center[axis];
            *of++ = sphere.radius;
        }
        attach(scene_, geometry);
    }

    void add_instances(const Scene& scene) {
        const auto& mesh = std::get<std::shared_ptr<const Mesh>>(scene.objects[0].shape);
        mesh_ = rtcNewScene(device_);
        bench::add_triangles(device_, mesh_, *mesh);
        rtcCommitScene(mesh_);
        for (const Object& object : scene.objects) {
            const RTCGeometry instance = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_INSTANCE);
            rtcSetGeometryInstancedScene(instance, mesh_);
            std::vector<float> columns;
            for (const Vec3f& column : object.placement.columns)
                columns.insert(columns.end(), {column.x, column.y, column.z});
            const Vec3f& by = object.placement.translation;
            columns.insert(columns.end(), {by.x, by.y, by.z});
            rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns.data());
            attach(scene_, instance);
        }
    }

    RTCDevice device_;
    RTCScene scene_;
    RTCScene mesh_ = nullptr;
};

void race(const char* name, const Scene& scene, const std::vector<Ray>& rays) {
    constexpr int repetitions = 5;
    std::unique_ptr<Accelerator> ours;
    std::unique_ptr<Embree> theirs;
    const double our_build = seconds_of([&] { ours = make_accelerator("bvh8", scene); });
    const double their_build = seconds_of([&] { theirs = std::make_unique<Embree>(scene); });
    std::vector<std::int64_t> hits(rays.size()), embree_hits(rays.size());
    std::vector<double> our_closest, their_closest, our_any, their_any;
    int hit = 0, different = 0;
    Traversal traversal;
    for (int i = 0; i < repetitions; ++i) {
        our_closest.push_back(seconds_of([&] {
            for (std::size_t r = 0; r < rays.size(); ++r) {
                const auto found = ours->closest(rays[r], traversal);
                hits[r] = found ? std::int64_t{found->primitive.object} : -1;
            }
        }));
        their_closest.push_back(seconds_of([&] {
            for (std::size_t r = 0; r < rays.size(); ++r) embree_hits[r] = theirs->closest(rays[r]);
        }));
        our_any.push_back(seconds_of([&] {
            for (std::size_t r = 0; r < rays.size(); ++r) hit += ours->occluded(rays[r], traversal);
        }));
        their_any.push_back(seconds_of([&] {
            for (std::size_t r = 0; r < rays.size(); ++r) hit += theirs->any(rays[r]);
        }));
    }
    for (std::size_t r = 0; r < rays.size(); ++r) different += hits[r] != embree_hits[r];
    const double count = static_cast<double>(rays.size());
    fmt::print("{}: {} objects, {} rays, {:.0f} % hit, {} answers differ\n", name, scene.objects.size(), rays.size(),
               100 * hit / (2.0 * repetitions * count), different);
    const auto row = [&](const char* what, double us, double them, const char* unit, double ratio) {
        fmt::print("  {:9}{:>12.3f}{:>12.3f} {:12} {:.2f} of Embree\n", what, us, them, unit, ratio);
    };
    const auto speed = [&](const char* what, const std::vector<double>& us, const std::vector<double>& them) {
        row(what, count / median(us) / 1e6, count / median(them) / 1e6, "Mrays/s", median(them) / median(us));
    };
    speed("closest", our_closest, their_closest);
    speed("any", our_any, their_any);
    row("build", our_build, their_build, "s", our_build / their_build);
    const double our_bytes = static_cast<double>(ours->bytes()), their_bytes = static_cast<double>(theirs->bytes);
    row("bytes", our_bytes / 1e6, their_bytes / 1e6, "MB", our_bytes / their_bytes);
}

}  // namespace

int main(int count, char** words) {
    keep_freed_memory();  // as a program does (base/program.cpp)
    const auto number = [&](int i, int otherwise) { return i < count ? std::atoi(words[i]) : otherwise; };
    const auto rays = rays_in(number(3, 200'000));
    race("spheres", spheres(number(1, 1'000'000)), rays);
    race("instances of 5120 triangles", instances(number(2, 100'000)), rays);
}
