// bench_scale FOLDER [LEVELS] [THREADS]: bumpy spheres from 5120 triangles on, four times as many each time (levels 4
// to LEVELS, 10 unless said otherwise: 20 971 520), are written to FOLDER as PLY. Processes of their own read each, and
// build bvh8, or Embree's tree, over it: bytes a triangle, mesh and all, at the end and at the peak, and nanoseconds of
// a ray beside a + b log2 n, and beside a read of memory that waits for the one before it. Rays are asked one after the
// other, and 1024 together (of Embree by rtcIntersect1M and rtcOccluded1M).

#include "chain_of_reads.h"
#include "embree_ray.h"
#include "embree_triangles.h"

#include "bench/line_through.h"
#include "bench/seconds_of.h"
#include "raylab/accelerator/accelerator.h"
#include "raylab/accelerator/trace_rays.h"
#include "raylab/base/heap.h"
#include "raylab/experiment/adversarial/adversarial.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/experiment/measure/quantile.h"
#include "raylab/scene/mesh/read_mesh.h"
#include "raylab/scene/scene.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

using namespace raylab;
using bench::line_through;
using bench::seconds_of;

namespace {

/// Of one mesh.
struct Measured {
    double triangles, read, build;             // seconds
    double peak_of_reading, peak, at_the_end;  // bytes, of the whole process
    double tree;                               // bytes, by which the process grew
    std::array<double, 6> nanoseconds;         // of a ray: one after the other and together, by the questions below
};

// Which of two kinds of rays are asked for what.
struct Question {
    std::size_t kind;
    RayQuestion answer;
    const char* name;
};
constexpr std::array questions{Question{0, RayQuestion::nearest, "camera"},
                               Question{1, RayQuestion::nearest, "incoherent"},
                               Question{1, RayQuestion::any, "incoherent, any hit"}};
constexpr auto ours = "bvh8", embree = "embree";

void write_ply(const Mesh& mesh, const std::string& path) {
    std::ofstream file(path, std::ios::binary);
    file << "ply\nformat binary_little_endian 1.0\nelement vertex " << mesh.vertices.size()
         << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << mesh.faces.size()
         << "\nproperty list uchar int vertex_indices\nend_header\n";
    const auto write = [&](const auto& value) { file.write(reinterpret_cast<const char*>(&value), sizeof value); };
    for (const Vec3f& vertex : mesh.vertices) write(vertex);
    for (const Mesh::Face& face : mesh.faces) {
        file.put(3);
        write(face);
    }
}

double resident_bytes() {
    std::size_t pages = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> pages >> resident;
    return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

double peak_bytes() {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    return 1024.0 * static_cast<double>(used.ru_maxrss);
}

// A ray of a camera above the sphere; and one from anywhere near the sphere in any direction.
std::array<Ray, 2> camera_and_incoherent(adversarial::Draw& draw, int i, int count) {
    const int side = static_cast<int>(std::sqrt(count));
    const double x = (i % side + 0.5) / side - 0.5, y = (i / side % side + 0.5) / side - 0.5;
    return {Ray{{0, 0, 3}, {cast<float>(0.7 * x), cast<float>(0.7 * y), -1}}, {draw.in_cube(1.2f), draw.in_cube(1)}};
}

class Ours {
public:
    Ours(const Scene& scene, int threads) : tree_(make_accelerator("bvh8", scene, {.threads = threads})) {}
    bool hits(const Ray& ray) {
        Traversal traversal;
        return tree_->closest(ray, traversal).has_value();
    }
    bool is_occluded(const Ray& ray) {
        Traversal traversal;
        return tree_->occluded(ray, traversal);
    }

    int hits_together(std::span<const Ray> rays) {
        int hits = 0;
        Traversal traversal;
        for (const auto& hit : tree_->closest_of(rays, traversal)) hits += hit.has_value();
        return hits;
    }
    int occluded_together(std::span<const Ray> rays) {
        Traversal traversal;
        return static_cast<int>(std::ranges::count(tree_->occluded_of(rays, traversal), true));
    }

private:
    std::unique_ptr<Accelerator> tree_;
};

class Embree {
public:
    Embree(const Scene& scene, int threads)
        : device_(rtcNewDevice(fmt::format("threads={}", threads).c_str())), scene_(rtcNewScene(device_)) {
        const Mesh& mesh = *std::get<std::shared_ptr<const Mesh>>(scene.objects[0].shape);
        bench::add_triangles(device_, scene_, mesh);
        rtcCommitScene(scene_);
    }
    ~Embree() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    Embree(const Embree&) = delete;
    Embree& operator=(const Embree&) = delete;

    bool hits(const Ray& ray) {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit hit = asked(ray);
        rtcIntersect1(scene_, &context, &hit);
        return is_hit(hit);
    }
    bool is_occluded(const Ray& ray) {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRay asked = bench::in_embree(ray);
        rtcOccluded1(scene_, &context, &asked);
        return is_stopped(asked);
    }

    int hits_together(std::span<const Ray> rays) {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        std::vector<RTCRayHit> all;
        all.reserve(rays.size());
        for (const Ray& ray : rays) all.push_back(asked(ray));
        rtcIntersect1M(scene_, &context, all.data(), static_cast<unsigned>(all.size()), sizeof(RTCRayHit));
        return static_cast<int>(std::ranges::count_if(all, is_hit));
    }
    int occluded_together(std::span<const Ray> rays) {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        std::vector<RTCRay> all;
        all.reserve(rays.size());
        for (const Ray& ray : rays) all.push_back(bench::in_embree(ray));
        rtcOccluded1M(scene_, &context, all.data(), static_cast<unsigned>(all.size()), sizeof(RTCRay));
        return static_cast<int>(std::ranges::count_if(all, is_stopped));
    }

private:
    static RTCRayHit asked(const Ray& ray) {
        RTCRayHit hit{.ray = bench::in_embree(ray), .hit = {}};
        hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        return hit;
    }
    static bool is_hit(const RTCRayHit& hit) { return hit.hit.geomID != RTC_INVALID_GEOMETRY_ID; }
    static bool is_stopped(const RTCRay& ray) { return ray.tfar < 0; }

    RTCDevice device_;
    RTCScene scene_;
};

// What a process measures of itself.
template <class Tree>
Measured measured(const std::string& path, int threads) {
    Measured of{};
    Scene scene;
    of.read = seconds_of(CLOCK_MONOTONIC,
                         [&] { scene.objects.push_back({.shape = std::make_shared<const Mesh>(read_mesh(path))}); });
    of.triangles = static_cast<double>(std::get<std::shared_ptr<const Mesh>>(scene.objects[0].shape)->faces.size());
    of.peak_of_reading = peak_bytes();
    const double before = resident_bytes();
    std::optional<Tree> tree;
    of.build = seconds_of(CLOCK_MONOTONIC, [&] { tree.emplace(scene, threads); });
    of.peak = peak_bytes();
    of.at_the_end = resident_bytes();
    of.tree = std::max(of.at_the_end - before, 0.0);  // (a small one may lie where the file was read)
    constexpr int count = 1 << 18, repetitions = 5;
    std::array<std::vector<Ray>, 2> rays;
    adversarial::Draw draw(1);
    for (int i = 0; i < count; ++i) {
        const auto two = camera_and_incoherent(draw, i, count);
        for (std::size_t kind = 0; kind < rays.size(); ++kind) rays[kind].push_back(two[kind]);
    }
    const auto time = [&](const auto& hits) {
        std::vector<double> times;
        for (int i = 0; i < repetitions; ++i)
            times.push_back(seconds_of(CLOCK_PROCESS_CPUTIME_ID, [&] {
                if (hits() == 0) fmt::print(stderr, "no ray hits\n");
            }));
        return 1e9 * median(times) / count;
    };
    for (std::size_t i = 0; i < questions.size(); ++i) {
        const bool nearest = questions[i].answer == RayQuestion::nearest;
        const std::span<const Ray> asked = rays[questions[i].kind];
        of.nanoseconds[2 * i] = time([&] {
            int hits = 0;
            for (const Ray& ray : asked) hits += nearest ? tree->hits(ray) : tree->is_occluded(ray);
            return hits;
        });
        of.nanoseconds[2 * i + 1] = time([&] {
            constexpr std::size_t at_once = 1024;
            int hits = 0;
            for (std::size_t begin = 0; begin < count; begin += at_once) {
                const auto some = asked.subspan(begin, at_once);
                hits += nearest ? tree->hits_together(some) : tree->occluded_together(some);
            }
            return hits;
        });
    }
    return of;
}

// The same, told by a child that has nothing else in its memory.
Measured measured_apart(const char* whose, const std::string& path, int threads) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) std::exit(1);
    const pid_t child = fork();
    if (child == 0) {
        dup2(ends[1], STDOUT_FILENO);
        const std::string number = std::to_string(threads);
        execl("/proc/self/exe", "bench_scale", whose, path.c_str(), number.c_str(), nullptr);
        _exit(1);
    }
    close(ends[1]);
    Measured of{};
    const bool told = read(ends[0], &of, sizeof of) == sizeof of;
    close(ends[0]);
    waitpid(child, nullptr, 0);
    if (!told) std::exit(1);
    return of;
}

}  // namespace

int main(int count, char** words) {
    keep_freed_memory();  // as a program does (base/program.cpp)
    if (count < 2 || words[1][0] == '-') {
        fmt::print(stderr, "bench_scale FOLDER [LEVELS] [THREADS]\n");
        return 2;
    }
    const auto number = [&](int i, int otherwise) { return i < count ? std::atoi(words[i]) : otherwise; };
    const std::string first = words[1];
    if (first == ours || first == embree) {
        const Measured of = (first == ours ? measured<Ours> : measured<Embree>)(words[2], number(3, 1));
        return std::fwrite(&of, sizeof of, 1, stdout) == 1 ? 0 : 1;
    }
    std::filesystem::create_directories(first);
    std::map<const char*, std::vector<Measured>> all;
    fmt::print(
        "                                    | bytes a triangle,        at the    | ns a ray, one by one and together:");
    for (const Question& question : questions) fmt::print(" {};", question.name);
    fmt::print("\n          triangles  read, s build, s | reading    peak     end |\n");
    for (int level = 4; level <= number(2, 10); ++level) {
        const std::string path = fmt::format("{}/bumpy_{}.ply", first, level);
        if (!std::filesystem::exists(path)) write_ply(bumpy_sphere(level), path);
        for (const char* whose : {ours, embree}) {
            const Measured of = all[whose].emplace_back(measured_apart(whose, path, number(3, 1)));
            fmt::print("{:9}{:10.0f}{:9.2f}{:9.2f} |{:8.1f}{:8.1f}{:8.1f} |{:7.0f}\n", whose, of.triangles, of.read,
                       of.build, of.peak_of_reading / of.triangles, of.peak / of.triangles,
                       of.at_the_end / of.triangles, fmt::join(of.nanoseconds, ""));
            std::fflush(stdout);
        }
    }
    fmt::print("ns of a read that waits for the one before it, at random places of as many bytes as bvh8 takes:");
    for (const Measured& of : all[ours]) fmt::print(" {:.0f}", bench::nanoseconds_of_a_read(of.tree));
    fmt::print("\n");
    for (const auto& [whose, measured] : all)
        for (std::size_t kind = 0; kind < 2 * questions.size(); ++kind) {
            std::vector<double> x, y;
            for (const Measured& of : measured) {
                x.push_back(std::log2(of.triangles));
                y.push_back(of.nanoseconds[kind]);
            }
            const auto [a, b] = line_through(x, y);
            fmt::print("{}, {}{}: {:.0f} + {:.1f} log2 n ns; measured over that:", whose, questions[kind / 2].name,
                       kind % 2 == 0 ? "" : ", together", a, b);
            for (std::size_t i = 0; i < x.size(); ++i) fmt::print(" {:.2f}", y[i] / (a + b * x[i]));
            fmt::print("\n");
        }
}
