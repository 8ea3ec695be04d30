#include "cuts_of_six.h"

#include "raylab/accelerator/bvh/box_tree.h"
#include "raylab/geometry/bounds/box.h"
#include "raylab/report/plane/plane_sketch.h"
#include "raylab/report/plane/plane_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace raylab::volumes {

namespace {

using namespace plane_ink;

// A thing with its box.
struct Thing {
    std::string name;
    Box box;
    double center() const { return box.center().x; }
};

// The things from left to right, by their boxes' centers.
std::vector<Thing> things(const Scene& scene) {
    std::vector<Thing> all;
    for (const Object& object : scene.objects)
        all.push_back({scene.materials[object.front].name, bounds(object.shape, object.placement).value()});
    std::ranges::sort(all, {}, &Thing::center);
    return all;
}

Box around(std::span<const Thing> things) {
    Box box;
    for (const Thing& thing : things) box = unite(box, thing.box);
    return box;
}

struct Cut {
    std::size_t below;  // so many things lie below it
    Box low, high;
    double low_share, high_share;  // of the surface of the box around all
    double work;                   // in tests of a thing
};

std::vector<Cut> cuts_of(std::span<const Thing> things) {
    const double all = surface_area(around(things));
    std::vector<Cut> cuts;
    for (std::size_t below = 1; below < things.size(); ++below) {
        Cut cut{below, around(things.first(below)), around(things.subspan(below)), 0, 0, 0};
        cut.low_share = surface_area(cut.low) / all;
        cut.high_share = surface_area(cut.high) / all;
        cut.work = box_visit_cost + cut.low_share * static_cast<double>(below) +
                   cut.high_share * static_cast<double>(things.size() - below);
        cuts.push_back(cut);
    }
    return cuts;
}

}  // namespace

std::vector<std::string> cuts_header() {
    return {"cut between", "things left", "their share of S", "things right", "their share of S", "work"};
}

std::vector<std::vector<std::string>> cuts_rows(const Scene& scene) {
    const auto all = things(scene);
    std::vector<std::vector<std::string>> rows;
    for (const Cut& cut : cuts_of(all))
        rows.push_back({all[cut.below - 1].name + ", " + all[cut.below].name, std::to_string(cut.below),
                        fmt::format("{:.3f}", cut.low_share), std::to_string(all.size() - cut.below),
                        fmt::format("{:.3f}", cut.high_share), fmt::format("{:.2f}", cut.work)});
    return rows;
}

PlaneDrawing draw_cuts(const Scene& scene) {
    const auto all = things(scene);
    const auto cuts = cuts_of(all);
    const Box whole = around(all);
    const PlaneView view(2, {}, whole);
    const Cut& best = *std::ranges::min_element(cuts, {}, &Cut::work);
    PlaneSketch sketch;
    const std::array sides{best.low, best.high};
    for (const Box& side : sides) sketch.add(*view.figure(Bound(side)), {.line = "", .fill = pale_blue});
    for (const Object& object : scene.objects)
        for (const Wires& piece : wires_of(object.shape, 0, object.placement))
            sketch.add(*view.figure(piece), {.line = "#55555f", .fill = "#ffffff", .width = 1.2});
    for (const Thing& thing : all)
        sketch.add(*view.figure(Bound(thing.box)), {.line = grey, .width = 1.2, .dash = PlaneStyle::Dash::dotted});
    for (const Box& side : sides) sketch.add(*view.figure(Bound(side)), {.line = blue, .width = 2.5});
    for (const Cut& cut : cuts) {
        const double x = (all[cut.below - 1].center() + all[cut.below].center()) / 2;
        const bool is_best = cut.below == best.below;
        sketch.line({x, whole.min.y - 0.05}, {x, whole.max.y + 0.1},
                    {.line = is_best ? vermilion : orange,
                     .width = is_best ? 3.0 : 1.5,
                     .dash = is_best ? PlaneStyle::Dash::solid : PlaneStyle::Dash::dashed});
        // Cuts that are close to each other have their numbers on different lines.
        const double up = cut.below % 2 == 0 ? -28 : -8;
        sketch.words({x, whole.max.y + 0.1},
                     fmt::format("{}{:.2f}{}", is_best ? "**" : "", cut.work, is_best ? "**" : ""),
                     {.aside = {0, up}, .anchor = Anchor::center, .height = 13});
    }
    return {.low = {whole.min.x - 0.1, whole.min.y - 0.1},
            .high = {whole.max.x + 0.1, whole.max.y + 0.55},
            .width = 960,
            .height = 620,
            .marks = sketch.marks()};
}

}  // namespace raylab::volumes
