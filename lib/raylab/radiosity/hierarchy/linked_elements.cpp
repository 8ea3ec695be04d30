#include "raylab/radiosity/hierarchy/linked_elements.h"

#include "raylab/radiosity/scene_system.h"
#include "raylab/radiosity/solve/residual.h"
#include "raylab/scene/background.h"
#include "raylab/scene/mean_of_channels.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raylab {

LinkedElements::LinkedElements(const PatchMesh& mesh, const PatchVisibility& visibility,
                               const HierarchyOptions& options)
    : mesh_(mesh),
      visibility_(visibility),
      options_(options),
      lights_(mesh, visibility),
      elements_(mesh, options.smallest) {
    for (std::size_t i = 0; i < elements_.size(); ++i) add_state(i);
    look_around();
    allowed_ = options.error * ambient();
}

// The first entries of an element's state. A quarter is as bright as the whole until it is solved.
void LinkedElements::add_state(std::size_t element) {
    const Element& one = elements_[element];
    links_.emplace_back();
    direct_.emplace_back();
    open_shares_.push_back(1);
    backgrounds_.emplace_back(0);
    light_.emission.emplace_back(0);
    light_.reflectance.push_back(patch_reflectance(mesh_, one.patch));
    const Color radiosity = one.parent == element ? Color(0) : light_.radiosity[one.parent];
    light_.radiosity.push_back(radiosity);
    light_.least.push_back(mean_of_channels(radiosity));
    light_.most.push_back(mean_of_channels(radiosity));
}

std::uint32_t LinkedElements::quarter(std::uint32_t element) {
    const std::uint32_t first = elements_.quartered(element);
    for (std::size_t i = links_.size(); i < elements_.size(); ++i) add_state(i);
    return first;
}

// What elements that are new since the last call see beside other elements: lights, and sides without patches.
void LinkedElements::look_around() {
    constexpr int rays = 16;
    const std::size_t first = looked_;
    looked_ = elements_.size();
    for_each_piece(elements_.size() - first, 64, options_.threads, [&](std::size_t begin, std::size_t end) {
        Traversal traversal;
        for (std::size_t i = first + begin; i < first + end; ++i) {
            const PatchVisibility::Part part{elements_[i].root, elements_[i].patch};
            direct_[i] = lights_.on(part, options_.light_points, traversal);
            if (options_.rays == 0 && !sends_light(mesh_.model.scene.background)) continue;
            const auto around = visibility_.surroundings(part, rays, traversal);
            if (options_.rays > 0) open_shares_[i] = around.with_patches;
            backgrounds_[i] = around.background;
        }
    });
    for (std::size_t i = first; i < elements_.size(); ++i)
        light_.emission[i] =
            std::numbers::pi * mesh_.material(elements_[i].patch).emission + light_.reflectance[i] * direct_[i].mean;
}

void LinkedElements::quarter_under_lights() {
    while (quartered_under_lights_ < elements_.size()) {
        look_around();
        const std::size_t end = elements_.size();
        for (std::size_t i = quartered_under_lights_; i < end; ++i) {
            const Color& rho = light_.reflectance[i];
            const bool differs = std::max({rho.r, rho.g, rho.b}) * direct_[i].spread > allowed_;
            if (elements_[i].is_leaf() && differs && elements_.can_be_quartered(i))
                quarter(static_cast<std::uint32_t>(i));
        }
        quartered_under_lights_ = end;
    }
}

std::vector<double> LinkedElements::filled(const std::vector<double>& open) const {
    return received<double>(elements_, links_, open, options_.threads,
                            [](std::uint32_t, const Link& link) { return link.factor; });
}

void LinkedElements::solve(double residual) {
    const auto open = open_areas(elements_, open_shares_), share = filled(open);
    constexpr int most_iterations = 100'000;
    for (int i = 0; i < most_iterations; ++i) {
        auto arriving = gathered_light(elements_, links_, open, light_.radiosity, options_.threads);
        for (std::size_t e = 0; e < arriving.size(); ++e)
            arriving[e] += background_light({open_shares_[e], backgrounds_[e]}, share[e]);
        const Radiosities before = light_.radiosity;
        pull_up(elements_, arriving, open, light_);
        ++work_.iterations;
        work_.residual = relative(largest_change(before, light_.radiosity), largest_of(light_.radiosity));
        if (work_.residual <= residual) break;
    }
    ++work_.rounds;
}

double LinkedElements::ambient() const {
    double power = 0, absorbing = 0;
    for (std::size_t i = 0; i < elements_.roots(); ++i) {
        const Color background = background_light({1, backgrounds_[i]}, 0);
        const double area = elements_[i].patch.area;
        power += area * mean_of_channels(light_.emission[i] + light_.reflectance[i] * background);
        absorbing += area * (1 - mean_of_channels(light_.reflectance[i]));
    }
    return power / absorbing;
}

void LinkedElements::sum_errors(const std::vector<double>& open) {
    const auto errors =
        received<double>(elements_, links_, open, options_.threads,
                         [&](std::uint32_t receiver, const Link& link) { return link_error(light_, receiver, link); });
    double area = 0, sum = 0;
    for (std::size_t i = 0; i < elements_.size(); ++i) {
        if (!elements_[i].is_leaf()) continue;
        work_.largest_error = std::max(work_.largest_error, errors[i]);
        sum += elements_[i].patch.area * errors[i];
        area += elements_[i].patch.area;
    }
    work_.mean_error = sum / area;
}

HierarchicalRadiosity LinkedElements::result() && {
    auto open = open_areas(elements_, open_shares_);
    work_.allowed = allowed_;
    sum_errors(open);
    auto share = filled(open);
    return {std::move(elements_),
            std::move(links_),
            std::move(light_),
            std::move(open),
            std::move(share),
            std::move(backgrounds_),
            work_};
}

}  // namespace raylab
