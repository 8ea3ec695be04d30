#include "drawings.h"

#include "raylab/report/plane/plane_sketch.h"

#include <array>
#include <cmath>

namespace raylab::shadows {

namespace {

using namespace plane_ink;

void cross(PlaneSketch& sketch, PlanePoint at) {
    sketch.words(at, "**×**", {.aside = {0, 8}, .anchor = Anchor::center, .color = "#b00000", .height = 17});
}

PlanePoint between(PlanePoint from, PlanePoint to, double share) {
    return {std::lerp(from.x, to.x, share), std::lerp(from.y, to.y, share)};
}

// The share of the way from a point to a light where it enters the ball; above 1: never.
double share_to_ball(PlanePoint from, PlanePoint to, PlanePoint center, double radius) {
    const PlanePoint way{to.x - from.x, to.y - from.y}, to_center{center.x - from.x, center.y - from.y};
    const double a = way.x * way.x + way.y * way.y, b = way.x * to_center.x + way.y * to_center.y,
                 c = to_center.x * to_center.x + to_center.y * to_center.y - radius * radius;
    const double discriminant = b * b - a * c;
    return discriminant < 0 ? 2 : (b - std::sqrt(discriminant)) / a;
}

}  // namespace

PlaneDrawing draw_shadow_rays() {
    PlaneSketch sketch;
    const PlanePoint center{0, 1}, warm{-3.2, 4.2}, cool{3.6, 4.4};
    const double radius = 0.8;
    sketch.line({-4.5, 0}, {4.5, 0}, stroke(black, 3));
    sketch.circle(center, radius, {.line = "#444444", .fill = pale_grey, .width = 2});
    const auto ask = [&](PlanePoint from, PlanePoint light, const char* color, Dash dash) {
        const double share = share_to_ball(from, light, center, radius);
        const bool free = share > 1;
        const PlanePoint end = between(from, light, free ? 0.95 : share);
        sketch.arrow(from, end, stroke(color, 2.5, dash));
        if (!free) cross(sketch, end);
    };
    constexpr std::array places = {-3.2, 1.55, 0.0};
    constexpr std::array names = {"A: both", "C: the cool one", "B: none"};
    for (std::size_t i = 0; i < places.size(); ++i) {
        const PlanePoint at{places[i], 0};
        ask(at, warm, vermilion, solid);
        ask(at, cool, blue, dashed);
        sketch.dot(at, 5, black);
        sketch.text({at.x, -0.42}, names[i], black, Anchor::center);
    }
    sketch.light(warm, "#f2a65e");
    sketch.light(cool, "#7db8e8");
    sketch.text({warm.x - 0.25, warm.y}, "warm light", vermilion, Anchor::right);
    sketch.text({cool.x + 0.25, cool.y}, "cool light", blue);
    return sketch.drawing({-4.9, -0.6}, {5.1, 4.8}, 760, 430);
}

PlaneDrawing draw_acne() {
    PlaneSketch sketch;
    const auto surface = [](double x) { return 0.16 * x; };
    sketch.polygon({{-1, surface(-1)}, {11, surface(11)}, {11, -2}, {-1, -2}}, filled(pale_grey));
    sketch.line({-1, surface(-1)}, {11, surface(11)}, stroke(black, 3));
    for (int i = 0; i < 10; ++i) {
        // The exact hit, and the nearest point whose height is a float, here a whole number.
        const double x = 0.35 + i, exact = surface(x), rounded = std::round(exact);
        const PlanePoint from{x, rounded}, to{x - 0.75, rounded + 1.7};
        const bool below = rounded < exact;
        sketch.line({x, exact}, from, stroke(grey, 1.5));
        if (below) {
            const double share = (exact - rounded) / (1.7 + 0.16 * 0.75);
            sketch.line(from, between(from, to, share), stroke(vermilion, 2));
            cross(sketch, between(from, to, share));
        } else {
            sketch.arrow(from, to, stroke(blue, 2));
        }
        sketch.dot(from, 6, below ? vermilion : blue);
    }
    sketch.text({4.2, -1.1}, "below the surface: blocked by the surface itself", vermilion);
    sketch.text({-0.8, 2.6}, "above it: free", blue);
    return sketch.drawing({-0.9, -1.4}, {10.6, 3.6}, 800, 360);
}

PlaneDrawing draw_starts() {
    PlaneSketch sketch;
    for (int x = -1; x <= 9; ++x)
        for (int y = -1; y <= 4; ++y) sketch.dot({double(x), double(y)}, 2.5, "#9a9a9a");
    const auto surface = [](double x) { return 0.35 + 0.28 * x; };
    sketch.line({-1.4, surface(-1.4)}, {9.4, surface(9.4)}, stroke(black, 3));
    sketch.text({6.4, surface(6.4) - 0.75}, "surface");
    const PlanePoint exact{3.62, surface(3.62)}, rounded{4, 1}, start{3, 2};
    sketch.arrow(start, {4.6, 3.7}, stroke(green));
    sketch.arrow(rounded, between(rounded, {5.75, 2.86}, 0.27), stroke(vermilion, 2.5, dashed));
    cross(sketch, between(rounded, {5.75, 2.86}, 0.36));
    sketch.dot(exact, 6, black);
    sketch.dot(rounded, 6, vermilion);
    sketch.dot(start, 6, green);
    sketch.words({3.5, 1.28}, "exact hit point *P*", {.aside = {-6, -6}, .anchor = Anchor::right});
    sketch.words(rounded, "rounded: below", {.aside = {12, 18}, .color = vermilion});
    sketch.words(start, "start *S*: the next floats beyond",
                 {.aside = {-12, -8}, .anchor = Anchor::right, .color = green});
    sketch.text({4.75, 3.55}, "to the light");
    return sketch.drawing({-1.3, -0.9}, {9.3, 4.1}, 760, 360);
}

PlaneDrawing draw_terminator() {
    PlaneSketch sketch;
    const PlanePoint a{-1.3, 0.35}, b{0.9, 0}, c{2.6, -0.95};
    sketch.polygon({{-2.6, 0.25}, a, b, c, {2.6, -1.4}, {-2.6, -1.4}}, filled(pale_grey));
    sketch.path({{-2.6, 0.25}, a, b, c}, stroke(black, 3));
    const PlanePoint here = between(b, c, 0.25), toward{-0.906, 0.423};
    const auto along = [](PlanePoint from, PlanePoint way, double length) {
        return PlanePoint{from.x + length * way.x, from.y + length * way.y};
    };
    const double facet_angle = std::atan2(-0.95, 1.7) + std::acos(0.0), mixed_angle = facet_angle + 0.14;
    const PlanePoint facet{std::cos(facet_angle), std::sin(facet_angle)},
        mixed{std::cos(mixed_angle), std::sin(mixed_angle)};
    sketch.arrow(here, along(here, toward, 0.55), stroke(grey, 2.5, dotted));
    for (const double share : {0.0, 0.35, 0.7})
        sketch.arrow(along({-2.5, 0.95 + share}, toward, -0.0), along({-2.5, 0.95 + share}, toward, -1.3),
                     stroke(orange, 2.5));
    sketch.arrow(here, along(here, facet, 0.9), stroke(blue));
    sketch.arrow(here, along(here, mixed, 0.95), stroke(vermilion, 2.5, dashed));
    sketch.dot(here, 5, black);
    sketch.text({-2.4, 1.9}, "light", orange);
    sketch.text({along(here, facet, 1).x + 0.02, along(here, facet, 1).y - 0.05}, "facet's normal: turned away", blue);
    sketch.text({along(here, mixed, 1).x - 0.1, along(here, mixed, 1).y + 0.12}, "the interpolated normal: lit",
                vermilion);
    return sketch.drawing({-2.5, -1.1}, {4, 2.1}, 760, 370);
}

}  // namespace raylab::shadows
