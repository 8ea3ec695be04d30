#include "raylab/radiosity/patch_form_factors.h"

#include "raylab/base/error.h"
#include "raylab/base/progress.h"
#include "raylab/base/tiles.h"
#include "raylab/radiosity/form_factor/contour_form_factor.h"
#include "raylab/radiosity/form_factor/form_factor_methods.h"
#include "raylab/radiosity/form_factor/hemicube.h"
#include "raylab/radiosity/form_factor/point_sampled_contour.h"
#include "raylab/radiosity/form_factor/polygon_form_factor.h"
#include "raylab/radiosity/system/for_each_row.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <mutex>
#include <vector>

namespace raylab {

namespace {

// Half of the longest distance in a patch, about: that between opposite corners of a square.
double radius_of(const Patch& patch) { return std::sqrt(patch.area / 2); }

bool has_point_in_front(const Patch& of, const Patch& plane) {
    // Corners of neighbours in one plane lie beside it by their rounding, which is no angle to send light at.
    const double least = 1e-6 * radius_of(of);
    return std::ranges::any_of(of.polygon(),
                               [&](const Vec3d& corner) { return dot(corner - plane.center, plane.normal) > least; });
}

double contour_exchange(const Patch& from, const Patch& to, int per_side) {
    return from.area * point_sampled_contour(from.polygon(), to.polygon(), per_side);
}

// What a method answers for two patches that are in full view of each other.
using Exchange = std::function<double(const Patch& from, const Patch& to)>;

double answered(const FormFactorMethod& method, const Patch& from, const Patch& to, int effort) {
    const auto answer = method.answer(from.polygon(), to.polygon(), effort);
    if (!answer) throw Error("expected patches whose form factor " + method.name + " knows, found others");
    return from.area * answer->value;
}

Exchange exchange_by(const FormFactorOptions& options) {
    if (options.method == "auto") return exchange_by_distance;
    const FormFactorMethod& method = form_factor_method_named(options.method);
    const int effort = options.effort > 0 || method.efforts.empty() ? options.effort : method.efforts.back();
    return [&method, effort](const Patch& from, const Patch& to) { return answered(method, from, to, effort); };
}

// The row of each patch by the hemicube at its centre.
CountedFormFactors by_hemicubes(const PatchMesh& mesh, const FormFactorOptions& options) {
    const int resolution = options.effort > 0 ? options.effort : 64;
    if (resolution % 2 != 0)
        throw Error(fmt::format("expected an even number of pixels along a hemicube's edge, found {}", resolution));
    const std::size_t n = mesh.patches.size();
    CountedFormFactors result{FormFactors(n), {.error_in_full_view = 1e-9, .error = 1e-9}};
    std::vector<std::span<const Vec3d>> polygons;
    for (const Patch& patch : mesh.patches) polygons.push_back(patch.polygon());
    Progress progress(options.label, n);
    for_each_piece(n, 4, options.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Patch& patch = mesh.patches[i];
            const Vec3d up = glm::normalize(patch.corners[1] - patch.corners[0]);
            const Hemicube cube = hemicube(patch.center, patch.normal, up, polygons, resolution);
            std::ranges::copy(form_factor_row(cube, n, DeltaFactors::normalised), result.factors.row(i).begin());
            progress.step();
        }
    });
    for (std::size_t i = 0; i < n; ++i)
        result.work.links += n - static_cast<std::size_t>(std::ranges::count(result.factors.row(i), 0.0));
    return result;
}

constexpr double factor_error =
    5e-3;  // of a row's sum, from factors at a few points: the largest found in closed rooms

// Makes both form factors of A_i F_ij above the diagonal. Block by block: a column's entries are far apart in memory,
// and writing them while rows are computed made two threads 1.5 times as fast as one, not twice.
void divide_by_areas(FormFactors& factors, const PatchMesh& mesh) {
    for_each_pair(mesh.patches.size(), [&](std::size_t i, std::size_t j) {
        const double both = factors.at(i, j);
        factors.at(i, j) = both / mesh.patches[i].area;
        factors.at(j, i) = both / mesh.patches[j].area;
    });
}

/// The variance of each row's sum, from pairs that are partly hidden. Threads add in any order, so the numbers are
/// whole: multiples of 2^-50.
class RowVariances {
public:
    explicit RowVariances(std::size_t rows) : values_(rows) {}

    void add(std::size_t row, double variance) { values_[row] += static_cast<std::uint64_t>(variance * 0x1p50); }
    double largest() const {
        std::uint64_t most = 0;
        for (const auto& value : values_) most = std::max(most, value.load());
        return static_cast<double>(most) * 0x1p-50;
    }

private:
    std::vector<std::atomic<std::uint64_t>> values_;
};

double unscaled(const KnownFormFactors& known, std::uint32_t from, std::uint32_t to) {
    return known.factors.at(from, to) / (known.scales[from] * known.scales[to]);
}

// Rows i and n - 1 - i together have the same number of pairs for each i: equal pieces of work for the threads.
template <class Row>
void for_balanced_rows(std::size_t n, int threads, Progress& progress, const Row& row) {
    for_each_piece((n + 1) / 2, 8, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            row(i);
            if (const std::size_t last = n - 1 - i; last != i) row(last);
            progress.step();
        }
    });
}

}  // namespace

bool face_each_other(const Patch& a, const Patch& b) { return has_point_in_front(a, b) && has_point_in_front(b, a); }

double exchange_by_distance(const Patch& a, const Patch& b) {
    const bool a_is_smaller = a.area <= b.area;
    const Patch &small = a_is_smaller ? a : b, &large = a_is_smaller ? b : a;
    const double apart = glm::distance(a.center, b.center) / (radius_of(a) + radius_of(b));
    if (apart > 7) return small.area * contour_form_factor(small.center, small.normal, large.polygon());
    if (apart > 2) return contour_exchange(small, large, 2);
    if (apart > 1.2) return contour_exchange(small, large, 4);
    // Plates that nearly cover each other have all of their light at their rims.
    if (dot(a.normal, b.normal) < -0.9) return exchange_area(a.polygon(), b.polygon());
    return contour_exchange(small, large, 6);
}

CountedFormFactors patch_form_factors(const PatchMesh& mesh, const PatchVisibility& visibility,
                                      const FormFactorOptions& options, const KnownFormFactors* known) {
    if (options.method == "hemicube") return by_hemicubes(mesh, options);
    const Exchange exchange = exchange_by(options);
    const std::size_t n = mesh.patches.size();
    CountedFormFactors result{FormFactors(n), {}};
    const auto begun = std::chrono::steady_clock::now();
    Progress progress(options.label, (n + 1) / 2);
    std::mutex mutex;
    RowVariances variances(n);
    const int rays_a_pair = visibility.nothing_hides() ? 0 : options.rays;
    for_balanced_rows(n, options.threads, progress, [&](std::size_t i) {
        Traversal traversal;
        FormFactorWork work;
        const Patch& from = mesh.patches[i];
        for (std::size_t j = i + 1; j < n; ++j) {
            const Patch& to = mesh.patches[j];
            if (known && known->before[i] && known->before[j]) {
                const double both = from.area * unscaled(*known, *known->before[i], *known->before[j]);
                result.factors.at(i, j) = both;
                if (both > 0) work.links += 2;
                continue;
            }
            if (!face_each_other(from, to)) continue;
            const auto [share, rays] =
                visibility.share(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), rays_a_pair, traversal);
            work.rays += static_cast<std::uint64_t>(rays_a_pair);
            if (share == 0) continue;
            const double in_full_view = exchange(from, to), both = share * in_full_view;
            result.factors.at(i, j) = both;
            if (both > 0) work.links += 2;
            if (share < 1) {
                const double of_share = share * (1 - share) / rays;
                variances.add(i, of_share * std::pow(in_full_view / from.area, 2));
                variances.add(j, of_share * std::pow(in_full_view / to.area, 2));
            }
        }
        const std::scoped_lock lock(mutex);
        result.work.links += work.links;
        result.work.rays += work.rays;
    });
    divide_by_areas(result.factors, mesh);
    result.work.error_in_full_view = factor_error;
    result.work.error = factor_error + 4 * std::sqrt(variances.largest());
    if (known) {
        result.work.rays += known->work.rays;
        result.work.error = std::max(result.work.error, known->work.error);
    }
    result.work.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    return result;
}

}  // namespace raylab
