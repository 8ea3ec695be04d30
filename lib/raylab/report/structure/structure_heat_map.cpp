#include "raylab/report/structure/structure_heat_map.h"

#include "raylab/base/tiles.h"
#include "raylab/image/color_map.h"
#include "raylab/image/draw.h"
#include "raylab/report/chart/axis.h"
#include "raylab/report/table.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>

namespace raylab {

namespace {

std::size_t index(const CostMap& map, int x, int y) {
    assert(x >= 0 && x < map.width && y >= 0 && y < map.height);
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width) + static_cast<std::size_t>(x);
}

// The colours of 0 to `top`, computed once, because each takes a search. They follow the cost's square root: where one
// of several maps costs ten times what another does, both then show where their cost lies.
class HeatScale {
public:
    explicit HeatScale(double top) : top_(top) {
        for (std::size_t i = 0; i < colors_.size(); ++i)
            colors_[i] = heat_color(static_cast<double>(i) / static_cast<double>(colors_.size() - 1));
    }
    const Pixel& color(double cost) const {
        const double share = std::sqrt(std::clamp(cost / top_, 0.0, 1.0));
        return colors_[static_cast<std::size_t>(std::lround(share * static_cast<double>(colors_.size() - 1)))];
    }

private:
    double top_;
    std::array<Pixel, 512> colors_;
};

constexpr int min_width = 480, legend_height = 80;

// The side of the square that shows a pixel: a small map is enlarged, or its legend would outweigh it.
int square_of(const CostMap& map) { return (std::max(map.width, min_width) + map.width - 1) / map.width; }

// By how much a legend is enlarged: a page shows a wide map reduced, and its legend is to be read there.
int legend_unit(const CostMap& map) { return std::max(1, map.width / 640); }

// Draws the bar of colours with its numbers, the title and the notes below the map.
void draw_legend(Image& image, const HeatScale& scale, double top, const CostMap& map, const std::string& title) {
    const int unit = legend_unit(map);
    const double map_end = image.height() - legend_height * unit;
    const double letter = 9.0 * unit;  // the height of a capital, in pixels
    const double left = 10.0 * unit, right = image.width() - left;
    const double bar = map_end + 28.0 * unit, below = bar + 12 * unit;
    draw_text(image, {left, map_end + 18.0 * unit}, letter, title, ink::black);
    for (int x = static_cast<int>(left); x < static_cast<int>(right); ++x)
        for (int y = static_cast<int>(bar); y < static_cast<int>(below); ++y)
            image.at(x, y) = scale.color(top * (x + 0.5 - left) / (right - left));
    draw_rectangle(image, {left, bar}, {right, below}, unit, ink::grey);
    AxisScale axis = axis_for({0, top}, AxisKind::linear, 0);
    axis.ticks = marks_with_room(axis, right - left, 1.6 * letter);
    for (const Tick& tick : axis.ticks) {
        const double x = std::lerp(left, right, axis.share(tick.at));
        draw_line(image, {x, below}, {x, below + 4 * unit}, unit, ink::black);
        const auto anchor = tick.at == 0 ? Anchor::left : x > right - 12 * unit ? Anchor::right : Anchor::center;
        draw_text(image, {x, below + 16 * unit}, letter, tick.text, ink::black, anchor);
    }
    const std::string beyond = map.largest() > top ? ", white from " + number_text(top) + " on" : "";
    draw_text(image, {left, below + 34 * unit}, letter,
              "mean " + number_text(map.mean()) + ", most " + number_text(map.largest()) + beyond, ink::black);
}

}  // namespace

double& CostMap::at(int x, int y) { return costs[index(*this, x, y)]; }
double CostMap::at(int x, int y) const { return costs[index(*this, x, y)]; }

double CostMap::mean() const {
    return costs.empty() ? 0 : std::accumulate(costs.begin(), costs.end(), 0.0) / static_cast<double>(costs.size());
}

double CostMap::largest() const { return costs.empty() ? 0 : *std::ranges::max_element(costs); }

std::string words(Cost cost) {
    switch (cost) {
        case Cost::primitive_tests:
            return "primitive tests";
        case Cost::box_tests:
            return "box tests";
        case Cost::steps:
            break;
    }
    return "steps";
}

double counted(const Traversal& traversal, Cost cost) {
    switch (cost) {
        case Cost::primitive_tests:
            return static_cast<double>(traversal.primitive_tests);
        case Cost::box_tests:
            return static_cast<double>(traversal.box_tests);
        case Cost::steps:
            break;
    }
    return static_cast<double>(traversal.steps);
}

CostMap cost_map(const CameraFrame& frame, int threads, const std::function<double(const Ray&)>& cost) {
    CostMap map{frame.image.width, frame.image.height};
    map.costs.resize(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height));
    for_each_tile(map.width, map.height, threads, "", [&](Tile tile) {
        for (int y = tile.y0; y < tile.y1; ++y)
            for (int x = tile.x0; x < tile.x1; ++x) map.at(x, y) = cost(eye_ray(frame, x + 0.5, y + 0.5));
    });
    return map;
}

CostMap cost_map(const Accelerator& structure, const CameraFrame& frame, Cost cost, int threads) {
    return cost_map(frame, threads, [&](const Ray& ray) {
        Traversal traversal;
        structure.closest(ray, traversal);
        return counted(traversal, cost);
    });
}

double common_top(const std::vector<CostMap>& maps, double share) {
    std::vector<double> all;
    for (const CostMap& map : maps) all.insert(all.end(), map.costs.begin(), map.costs.end());
    if (all.empty()) return 1;
    const auto place = all.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(all.size() - 1));
    std::ranges::nth_element(all, place);
    return std::max(1.0, *place);
}

Image heat_map(const CostMap& map, const std::string& title, double top) {
    if (!(top > 0)) top = common_top({map});
    const HeatScale scale(top);
    const int square = square_of(map), height = square * map.height;
    Image image(square * map.width, height + legend_height * legend_unit(map), ink::white);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < image.width(); ++x) image.at(x, y) = scale.color(map.at(x / square, y / square));
    draw_legend(image, scale, top, map, title);
    return image;
}

}  // namespace raylab
