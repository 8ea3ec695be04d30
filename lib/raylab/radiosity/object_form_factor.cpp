#include "raylab/radiosity/object_form_factor.h"

#include "raylab/base/error.h"
#include "raylab/base/nearest_name.h"
#include "raylab/radiosity/form_factor/contour_form_factor.h"
#include "raylab/radiosity/form_factor/form_factor_density.h"
#include "raylab/radiosity/form_factor/form_factor_methods.h"
#include "raylab/sampling/even_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace raylab {

namespace {

FacetSide shown_side(const Object& object, const SurfaceName& name, const Scene& scene) {
    const FacetSide only = object.sides == Sides::back ? FacetSide::back : FacetSide::front;
    const FacetSide side = name.side.value_or(only);
    if (object.sides != Sides::both && side != only)
        throw Error({scene.source, 0, name.path}, "a side that is shown",
                    side == FacetSide::front ? "the front of what is seen from the back only"
                                             : "the back of what is seen from the front only");
    return side;
}

// The numbers of the patches that are that side of that object; the scene's pieces are one patch each.
std::vector<std::uint32_t> patches_of(const PatchMesh& mesh, const Scene& scene, const SurfaceName& name) {
    std::vector<std::string> paths;
    for (const Object& object : scene.objects) paths.push_back(object.path);
    const auto object = std::ranges::find(paths, name.path);
    if (object == paths.end()) throw Error({scene.source}, "the path of an object", with_suggestion(name.path, paths));
    const auto number = static_cast<std::uint32_t>(object - paths.begin());
    const FacetSide side = shown_side(scene.objects[number], name, scene);
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < mesh.patches.size(); ++i)
        if (mesh.model.facets[mesh.patches[i].facet].object == number && mesh.patches[i].side == side)
            found.push_back(i);
    return found;
}

/// The share of light that passes, of a sum of pairs: the weighted rays that pass over all, in batches whose scatter
/// tells the error.
class PassingShare {
public:
    void add(int ray, double weight, bool passes) {
        auto& [all, passed] = batches_[static_cast<std::size_t>(ray) % batches_.size()];
        all += weight;
        if (passes) passed += weight;
    }

    double value() const {
        const auto [all, passed] = total();
        return all > 0 ? passed / all : 0;
    }

    double variance() const {
        const auto [all, passed] = total();
        if (!(all > 0)) return 0;
        const double n = static_cast<double>(batches_.size()), mean = all / n;
        double sum = 0;
        for (const Batch& batch : batches_) sum += std::pow((batch.passed - value() * batch.all) / mean, 2);
        return sum / (n * (n - 1));
    }

private:
    struct Batch {
        double all = 0, passed = 0;
    };
    Batch total() const {
        Batch sum;
        for (const Batch& batch : batches_) {
            sum.all += batch.all;
            sum.passed += batch.passed;
        }
        return sum;
    }
    std::array<Batch, 16> batches_;
};

/// What adds up over pairs of pieces.
struct Sum {
    double value = 0, variance = 0;
    std::uint64_t rays = 0;

    void add(double full, const PassingShare& share, int samples) {
        value += full * share.value();
        variance += full * full * share.variance();
        rays += static_cast<std::uint64_t>(samples);
    }
};

int rays_for_pair(int samples, std::size_t pairs) {
    return std::max(16, samples / static_cast<int>(std::min<std::size_t>(pairs, 1u << 30)));
}

// Area times form factor in full view, and its standard error.
FormFactorEstimate full_exchange(const FormFactorMethod& method, const Patch& a, const Patch& b) {
    const auto answer = method.answer(a.polygon(), b.polygon(), method.efforts.back());
    if (!answer) throw Error("expected surfaces whose form factor " + method.name + " knows, found others");
    return {a.area * answer->value, a.area * answer->standard_error};
}

}  // namespace

SurfaceName surface_name(const std::string& words) {
    for (const auto& [ending, side] : {std::pair{":front", FacetSide::front}, std::pair{":back", FacetSide::back}})
        if (words.ends_with(ending)) return {words.substr(0, words.size() - std::string_view(ending).size()), side};
    return {words};
}

ObjectFormFactor object_form_factor(const Scene& scene, const SurfaceName& from, const SurfaceName& to, double edge,
                                    int samples, const std::string& method_name) {
    const FormFactorMethod& method = form_factor_method_named(method_name);
    const PatchMesh mesh = pieces_of(scene, {edge});
    const PatchVisibility visibility(mesh);
    const auto senders = patches_of(mesh, scene, from), receivers = patches_of(mesh, scene, to);
    const int rays = rays_for_pair(samples, senders.size() * receivers.size());
    Traversal traversal;
    Sum sum;
    double area = 0;
    for (const std::uint32_t i : senders) {
        const Patch& a = mesh.patches[i];
        area += a.area;
        for (const std::uint32_t j : receivers) {
            const Patch& b = mesh.patches[j];
            const auto [full, error] = full_exchange(method, a, b);
            if (!(full > 0)) continue;
            PassingShare share;
            for (int k = 0; k < rays; ++k) {
                const auto [u, v, s, t] = even_point<4>(k + 1, {0.5, 0.5, 0.5, 0.5});
                const Vec3d p = point_of(a, u, v), q = point_of(b, s, t);
                const double weight = form_factor_density(p, a.normal, q, b.normal);
                if (weight > 0) share.add(k, weight, visibility.sees(i, p, j, q, traversal));
            }
            sum.add(full, share, rays);
            sum.variance += std::pow(error * share.value(), 2);
        }
    }
    return {sum.value / area, std::sqrt(sum.variance) / area, sum.rays, mesh.model.error};
}

ObjectFormFactor point_form_factor(const Scene& scene, const Vec3d& point, const Vec3d& normal, const SurfaceName& to,
                                   double edge, int samples) {
    const PatchMesh mesh = pieces_of(scene, {edge});
    const PatchVisibility visibility(mesh);
    const auto receivers = patches_of(mesh, scene, to);
    const int rays = rays_for_pair(samples, receivers.size());
    const Vec3d up = glm::normalize(normal);
    Traversal traversal;
    Sum sum;
    for (const std::uint32_t j : receivers) {
        const Patch& b = mesh.patches[j];
        const double full = contour_form_factor(point, up, b.polygon());
        if (!(full > 0)) continue;
        PassingShare share;
        for (int k = 0; k < rays; ++k) {
            const auto [s, t] = even_point<2>(k + 1, {0.5, 0.5});
            const Vec3d q = point_of(b, s, t);
            const double weight = form_factor_density(point, up, q, b.normal);
            if (weight > 0) share.add(k, weight, visibility.sees_point(j, q, point, traversal));
        }
        sum.add(full, share, rays);
    }
    return {sum.value, std::sqrt(sum.variance), sum.rays, mesh.model.error};
}

}  // namespace raylab
