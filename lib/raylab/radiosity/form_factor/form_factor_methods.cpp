#include "raylab/radiosity/form_factor/form_factor_methods.h"

#include "raylab/base/error.h"
#include "raylab/base/nearest_name.h"
#include "raylab/radiosity/form_factor/area_sampling.h"
#include "raylab/radiosity/form_factor/convex_polygon.h"
#include "raylab/radiosity/form_factor/disk_form_factor.h"
#include "raylab/radiosity/form_factor/hemicube.h"
#include "raylab/radiosity/form_factor/point_sampled_contour.h"
#include "raylab/radiosity/form_factor/polygon_form_factor.h"
#include "raylab/radiosity/form_factor/rectangle_form_factor.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <vector>

namespace raylab {

namespace {

using View = std::span<const Vec3d>;
using Answer = std::optional<FormFactorEstimate>;

FormFactorMethod sampling(const std::string& name, const std::string& source, PairPattern pattern) {
    return {name, source, "pair", {16, 64, 256, 1024, 4096, 16384}, [pattern](View from, View to, int pairs) -> Answer {
                const auto sampled = sampled_form_factor(from, to, {.pairs = pairs, .pattern = pattern},
                                                         [](const Vec3d&, const Vec3d&) { return 1.0; });
                return FormFactorEstimate{sampled.value, sampled.standard_error};
            }};
}

// A hemicube at the polygon's centre, turned with its first edge.
double by_hemicube(View from, View to, int resolution) {
    const std::array<View, 1> polygons{to};
    const Vec3d up = glm::normalize(from[1] - from[0]);
    const Hemicube view = hemicube(polygon_ball(from).center, polygon_normal(from), up, polygons, resolution);
    return form_factor_row(view, 1, DeltaFactors::normalised)[0];
}

Answer estimate(std::optional<double> value) { return value ? Answer(FormFactorEstimate{*value}) : std::nullopt; }

}  // namespace

std::string FormFactorMethod::effort_text(int count) const {
    if (effort.empty()) return "";
    const auto noun = std::min(effort.find(' '), effort.size());
    return fmt::format("{} {}{}{}", count, effort.substr(0, noun), count == 1 ? "" : "s", effort.substr(noun));
}

std::string FormFactorMethod::title(int count) const {
    return effort.empty() ? name : name + ", " + effort_text(count);
}

const std::vector<FormFactorMethod>& form_factor_methods() {
    static const std::vector<FormFactorMethod> methods{
        {"disk",
         "Wallace, Elmquist and Haines, SIGGRAPH 89",
         "",
         {1},
         [](View from, View to, int) { return estimate(disk_form_factor(from, to)); }},
        {"hemicube",
         "Cohen and Greenberg, SIGGRAPH 85",
         "pixel a side",
         {16, 32, 64, 128, 256, 512},
         [](View from, View to, int resolution) { return estimate(by_hemicube(from, to, resolution)); }},
        sampling("area, random", "Goral, Torrance, Greenberg and Battaile, SIGGRAPH 84, by pairs of points",
                 PairPattern::random),
        sampling("area, jittered", "the same, one pair in each cell", PairPattern::jittered),
        sampling("area, low-discrepancy", "the same, by Roberts' R4 sequence, 2018", PairPattern::low_discrepancy),
        {"contour",
         "Lambert, Photometria, 1760; Baum, Rushmeier and Winget, SIGGRAPH 89",
         "point a side",
         {1, 2, 3, 4, 6, 8, 12, 16},
         [](View from, View to, int per_side) { return estimate(point_sampled_contour(from, to, per_side)); }},
        {"polygon",
         "Schroeder and Hanrahan, SIGGRAPH 93",
         "",
         {1},
         [](View from, View to, int) { return estimate(polygon_form_factor(from, to)); }},
        {"closed",
         "Howell, A Catalog of Radiation Heat Transfer Configuration Factors",
         "",
         {1},
         [](View from, View to, int) { return estimate(rectangle_form_factor(from, to)); }}};
    return methods;
}

const FormFactorMethod& form_factor_method_named(const std::string& name) {
    const std::string whole = name == "area" ? "area, low-discrepancy" : name == "auto" ? "polygon" : name;
    std::vector<std::string> names{"auto", "area"};
    for (const FormFactorMethod& method : form_factor_methods()) {
        if (method.name == whole) return method;
        names.push_back(method.name);
    }
    throw Error("expected a form-factor method (" + fmt::format("{}", fmt::join(names, "; ")) + "), found " +
                with_suggestion(name, names));
}

}  // namespace raylab
