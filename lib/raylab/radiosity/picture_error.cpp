#include "raylab/radiosity/picture_error.h"

#include "raylab/base/tiles.h"
#include "raylab/radiosity/final_gather.h"
#include "raylab/radiosity/scene_system.h"
#include "raylab/sampling/even_point.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

namespace raylab {

namespace {

double mean_channel(const Color& color) { return (color.r + color.g + color.b) / 3; }

/// A place at which a solution is asked: u and v are point_of()'s.
struct AskedPlace {
    std::uint32_t patch;
    double u, v;
};

// As many on each patch as its area's share, to within one: places at equal steps of the area before them.
std::vector<AskedPlace> asked_places(const PatchMesh& mesh, std::size_t count) {
    const auto area = [&](const Patch& patch) { return mesh.material(patch).emission == Color(0) ? patch.area : 0; };
    double all = 0;
    for (const Patch& patch : mesh.patches) all += area(patch);
    std::vector<AskedPlace> places;
    double before = 0;
    for (std::uint32_t i = 0; i < mesh.patches.size(); ++i) {
        before += area(mesh.patches[i]);
        while (places.size() < count &&
               (static_cast<double>(places.size()) + 0.5) * all < before * static_cast<double>(count)) {
            const auto [u, v] = even_point<2>(static_cast<int>(places.size()), {0.5, 0.5});
            places.push_back({i, u, v});
        }
    }
    return places;
}

// What is shown at a place: its weights are those of point_of().
Color shown_at(const RadiosityView& view, const AskedPlace& at) {
    const Patch& patch = view.mesh.patches[at.patch];
    if (patch.corner_count == 4)
        return interpolated_radiosity(
            view, {at.patch, {(1 - at.u) * (1 - at.v), at.u * (1 - at.v), at.u * at.v, (1 - at.u) * at.v}});
    const bool turned = at.u + at.v > 1;
    const double u = turned ? 1 - at.u : at.u, v = turned ? 1 - at.v : at.v;
    return interpolated_radiosity(view, {at.patch, {1 - u - v, u, v, 0}});
}

struct Residuals {
    double shown, first, second;  // of both gathers, minus what is shown
    double returned;              // the share of what the place sends that it would get back by one reflection
};

}  // namespace

PictureError picture_error(const RadiosityView& view, int threads) {
    const auto begun = std::chrono::steady_clock::now();
    const std::size_t patches = view.mesh.patches.size();
    // A gather's work is in proportion to the patches. 96 points tell the error to about a tenth of itself.
    constexpr std::size_t most_pairs = 500'000;
    const auto places =
        asked_places(view.mesh, std::clamp<std::size_t>(most_pairs / std::max<std::size_t>(patches, 1), 96, 480));
    const FinalGather gather(view);
    std::vector<Residuals> found(places.size());
    for_each_piece(places.size(), 1, threads, [&](std::size_t begin, std::size_t end) {
        Traversal traversal;
        for (std::size_t i = begin; i < end; ++i) {
            const AskedPlace& at = places[i];
            const Patch& patch = view.mesh.patches[at.patch];
            const Vec3d point = point_of(patch, at.u, at.v);
            const double shown = mean_channel(shown_at(view, at));
            const auto by = [&](std::uint64_t sample) {
                return gather.at(at.patch, point, {GatherRays::End::random, 2 * i + sample}, traversal);
            };
            const auto first = by(0), second = by(1);
            found[i] = {shown, mean_channel(first.radiosity) - shown, mean_channel(second.radiosity) - shown,
                        mean_channel(patch_reflectance(view.mesh, patch)) * (first.filled + second.filled) / 2};
        }
    });
    double square = 0, residual = 0, shown = 0, returned = 0;
    for (const Residuals& one : found) {
        square += one.first * one.second;
        residual += (one.first + one.second) / 2;
        shown += one.shown;
        returned += one.returned;
    }
    PictureError error{.points = places.size(), .rays = 2 * places.size() * patches};
    const auto count = static_cast<double>(places.size());
    if (count == 0 || !(shown > 0)) return error;
    const double mean = residual / count, of_all = mean / (1 - returned / count);
    error.relative = std::sqrt(std::max(0.0, square / count - mean * mean) + of_all * of_all) / (shown / count);
    error.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    return error;
}

}  // namespace raylab
