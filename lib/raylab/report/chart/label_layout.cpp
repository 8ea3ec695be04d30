#include "raylab/report/chart/label_layout.h"

#include "raylab/image/draw.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

namespace raylab {

namespace {

constexpr double near = 11;  // pixels from a point to its name: the marker's radius and a gap
constexpr double marker_radius = 6;
constexpr double leader_from = 16;  // a name that is farther away than this needs a leader line
constexpr int rings = 16;           // how many steps outward are tried

struct Direction {
    double x, y;
};

// Right comes first, because a reader looks for a name there.
constexpr std::array<Direction, 12> directions = {{{1, 0},
                                                   {-1, 0},
                                                   {0.8, 0.6},
                                                   {0.8, -0.6},
                                                   {-0.8, 0.6},
                                                   {-0.8, -0.6},
                                                   {0, 1},
                                                   {0, -1},
                                                   {0.4, 0.9},
                                                   {0.4, -0.9},
                                                   {-0.4, 0.9},
                                                   {-0.4, -0.9}}};

/// The box of a name whose nearest edge or corner lies `distance` from its point in a direction, moved inside the frame
/// where it would stick out.
Rectangle box_at(const LabelRequest& request, const Direction& direction, double distance, const Rectangle& frame) {
    const double x = request.x + distance * direction.x;
    const double y = request.y + distance * direction.y;
    // At the sides the box begins at x; above and below it is centred.
    const double beside = direction.x > 0.3 ? x : direction.x < -0.3 ? x - request.width : x - request.width / 2;
    const double beneath = direction.y > 0.3 ? y : direction.y < -0.3 ? y - request.height : y - request.height / 2;
    const double left = std::clamp(beside, frame.x0, frame.x1 - request.width);
    const double bottom = std::clamp(beneath, frame.y0, frame.y1 - request.height);
    return {left, bottom, std::min(left + request.width, frame.x1), std::min(bottom + request.height, frame.y1)};
}

double distance_to(const Rectangle& box, double x, double y) {
    return std::hypot(std::max({box.x0 - x, 0.0, x - box.x1}), std::max({box.y0 - y, 0.0, y - box.y1}));
}

/// How much of the straight line from a point to its name is covered by other boxes.
double covered(const LabelRequest& request, const Rectangle& box, std::span<const Rectangle> others) {
    const double x = std::clamp(request.x, box.x0, box.x1), y = std::clamp(request.y, box.y0, box.y1);
    constexpr int steps = 24;
    int hidden = 0;
    for (int step = 4; step < steps; ++step) {  // the first steps lie under the point's own marker
        const double share = static_cast<double>(step) / steps;
        const double at_x = std::lerp(request.x, x, share), at_y = std::lerp(request.y, y, share);
        const auto hides = [&](const Rectangle& other) { return distance_to(other, at_x, at_y) < 1; };
        hidden += std::ranges::any_of(others, hides);
    }
    return hidden;
}

/// The cost of a place: hiding a marker costs most, then covering a line, then distance.
double cost_of(const LabelRequest& request, const Rectangle& box, const Surroundings& around,
               std::span<const Rectangle> placed) {
    const double distance = distance_to(box, request.x, request.y);
    const bool needs_leader = distance > leader_from;
    // A name that was moved inside the frame may be nearer, which must not be an advantage.
    double cost = std::max(distance, near);
    if (distance < marker_radius) cost += 1000;  // it hides its own point
    for (const auto& marker : around.markers) cost += 20 * box.overlap(marker);
    for (const auto& piece : around.lines) cost += 0.6 * box.overlap(piece);
    if (needs_leader) cost += 10 + 6 * covered(request, box, placed) + 3 * covered(request, box, around.markers);
    return cost;
}

/// The cheapest box that is inside the frame and does not overlap the names placed before, if there is one.
std::optional<Rectangle> best_box(const LabelRequest& request, const Surroundings& around,
                                  std::span<const Rectangle> placed) {
    const auto& frame = around.frame;
    if (request.width > frame.x1 - frame.x0 || request.height > frame.y1 - frame.y0) return std::nullopt;
    std::optional<Rectangle> best;
    double smallest = std::numeric_limits<double>::infinity();
    for (int ring = 0; ring < rings; ++ring)
        for (const auto& direction : directions) {
            const auto box = box_at(request, direction, near + ring * 0.75 * request.height, frame);
            if (std::ranges::any_of(placed, [&](const Rectangle& other) { return box.overlap(other) > 0; })) continue;
            const double cost = cost_of(request, box, around, placed);
            if (cost >= smallest) continue;
            smallest = cost;
            best = box;
        }
    return best;
}

PlacedLabel with_leader(const LabelRequest& request, const Rectangle& box) {
    PlacedLabel label{.box = box};
    if (distance_to(box, request.x, request.y) > leader_from) label.leader = PlacedLabel::Leader::line;
    label.leader_x = std::clamp(request.x, box.x0, box.x1);
    label.leader_y = std::clamp(request.y, box.y0, box.y1);
    return label;
}

}  // namespace

bool Rectangle::contains(const Rectangle& other) const {
    return other.x0 >= x0 && other.y0 >= y0 && other.x1 <= x1 && other.y1 <= y1;
}

double Rectangle::overlap(const Rectangle& other) const {
    const double width = std::min(x1, other.x1) - std::max(x0, other.x0);
    const double height = std::min(y1, other.y1) - std::max(y0, other.y0);
    return width > 0 && height > 0 ? width * height : 0;
}

std::vector<std::optional<PlacedLabel>> place_labels(std::span<const LabelRequest> requests,
                                                     const Surroundings& around) {
    std::vector<std::optional<PlacedLabel>> labels;
    std::vector<Rectangle> placed;
    for (const auto& request : requests) {
        const auto best = best_box(request, around, placed);
        labels.push_back(best ? std::optional(with_leader(request, *best)) : std::nullopt);
        if (best) placed.push_back(*best);
    }
    return labels;
}

std::vector<double> push_apart(std::span<const double> positions, double distance, double low, double high) {
    std::vector<std::size_t> order(positions.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return positions[i]; });

    // Neighbours that are too close form a group around the mean of the places they should have; groups that touch are
    // merged.
    struct Group {
        double request;  // the mean of the places that the members want for the first of them
        double count;
    };
    std::vector<Group> groups;
    for (const auto i : order) {
        groups.push_back({positions[i], 1});
        while (groups.size() > 1) {
            const auto last = groups.back();
            auto& before = groups[groups.size() - 2];
            if (before.request + before.count * distance <= last.request) break;
            before.request = (before.request * before.count + (last.request - before.count * distance) * last.count) /
                             (before.count + last.count);
            before.count += last.count;
            groups.pop_back();
        }
    }
    std::vector<double> column;
    for (const auto& [request, count] : groups)
        for (double member = 0; member < count; ++member) column.push_back(request + member * distance);
    // The ends of the column come last, from the top downward and then from the bottom upward, so that names stick out
    // at the top where there are too many.
    for (std::size_t i = column.size(); i-- > 0;)
        column[i] = std::min(column[i], i + 1 < column.size() ? column[i + 1] - distance : high);
    for (std::size_t i = 0; i < column.size(); ++i)
        column[i] = std::max(column[i], i > 0 ? column[i - 1] + distance : low);

    std::vector<double> apart(positions.size());
    for (std::size_t i = 0; i < order.size(); ++i) apart[order[i]] = column[i];
    return apart;
}

double label_width(std::string_view text, double font_size) {
    constexpr double capital = 1493.0 / 2048;  // its height in DejaVu Sans, in ems
    return text_width(std::string(text), capital * font_size);
}

double bold_label_width(std::string_view text, double font_size) {
    struct Letters {
        std::string_view among;
        double ems;
    };
    // The widths of the font's letters, rounded up to whole pixels, as they are drawn at 26 pixels (13, in a PNG of
    // twice the pixels).
    constexpr std::array<Letters, 6> widths = {{{" ijlIJ/|'", 0.35},
                                                {".,:;-", 0.40},
                                                {"frt()[]!", 0.48},
                                                {"cszL_", 0.61},
                                                {"aevxykoEFT0123456789", 0.695},
                                                {"mwMW@%", 1.0}}};
    double ems = 0;
    for (const char c : text) {
        // Skips the continuation bytes of a UTF-8 character.
        if ((static_cast<unsigned char>(c) & 0xC0) == 0x80) continue;
        const auto known = std::ranges::find_if(
            widths, [&](const Letters& letters) { return letters.among.find(c) != std::string_view::npos; });
        const bool wide = (c >= 'A' && c <= 'Z') || std::string_view("+=<>#~&").find(c) != std::string_view::npos;
        ems += known != widths.end() ? known->ems : wide ? 0.82 : 0.735;
    }
    return ems * font_size;
}

}  // namespace raylab
