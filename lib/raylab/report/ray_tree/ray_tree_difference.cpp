#include "raylab/report/ray_tree/ray_tree_difference.h"

#include "raylab/base/printable.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <string_view>

namespace raylab {

namespace {

constexpr std::array<std::string_view, 11> compared{"kind",  "depth",  "direction",  "object",       "ended",       "t",
                                                    "point", "normal", "throughput", "local colour", "contribution"};

std::string shown(int value) { return fmt::format("{}", value); }
std::string shown(double value) { return fmt::format("{:.6g}", value); }
std::string shown(const Vec3d& v) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x, v.y, v.z); }
std::string shown(const std::string& text) { return text.empty() ? "nothing" : text; }
std::string shown(RayKind kind) { return to_string(kind); }
std::string shown(Ending ended) { return to_string(ended); }

// Written positively: what is not a number is the same as nothing.
bool within(double difference, double size, const RayTreeTolerance& tolerance) {
    return std::isfinite(size) && difference <= tolerance.absolute + tolerance.relative * size;
}

bool same(double a, double b, const RayTreeTolerance& tolerance) {
    return a == b || within(std::abs(a - b), std::abs(b), tolerance);  // two infinite t are equal
}
bool same(const Vec3d& a, const Vec3d& b, const RayTreeTolerance& tolerance) {
    return within(glm::length(a - b), glm::length(b), tolerance);
}
template <class Word>
bool same(const Word& a, const Word& b, const RayTreeTolerance&) {
    return a == b;
}

class Comparison {
public:
    Comparison(const RayTree& got, const RayTree& expected, const RayTreeTolerance& tolerance)
        : got_(got),
          expected_(expected),
          got_below_(children(got)),
          expected_below_(children(expected)),
          tolerance_(tolerance) {}

    std::optional<RayTreeDifference> first() const {
        if (const auto eye = first_among({{0, 0}})) return eye;
        std::deque<Pair> waiting{{0, 0}};  // breadth first: the nearest to the eye first
        while (!waiting.empty()) {
            const Children below = matched_children(waiting.front());
            waiting.pop_front();
            if (below.unpaired) return below.unpaired;
            if (const auto child = first_among(below.matched)) return child;
            waiting.insert(waiting.end(), below.matched.begin(), below.matched.end());
        }
        if (same(got_.pixel, expected_.pixel, tolerance_)) return std::nullopt;
        return RayTreeDifference{.fields = {{"pixel", shown(got_.pixel), shown(expected_.pixel)}},
                                 .place = place_of(expected_, 0)};
    }

private:
    struct Pair {
        std::size_t got, expected;
    };
    struct Children {
        std::vector<Pair> matched;
        std::optional<RayTreeDifference> unpaired;  // the first one that only one of the trees has
    };

    // Of siblings the one that differs in the earlier field is reported: where a refracted ray is missing, its sister's
    // throughput is only a consequence.
    std::optional<RayTreeDifference> first_among(const std::vector<Pair>& siblings) const {
        std::optional<RayTreeDifference> first;
        for (const auto& pair : siblings) {
            auto fields = differing_fields(pair);
            if (fields.empty() || (first && rank(fields) >= rank(first->fields))) continue;
            first = RayTreeDifference{.got = pair.got,
                                      .expected = pair.expected,
                                      .fields = std::move(fields),
                                      .place = place_of(expected_, pair.expected)};
        }
        return first;
    }

    static std::ptrdiff_t rank(const std::vector<DifferingField>& fields) {
        return std::ranges::find(compared, fields.front().name) - compared.begin();
    }

    std::vector<DifferingField> differing_fields(const Pair& pair) const {
        const RayNode &got = got_.nodes[pair.got], &expected = expected_.nodes[pair.expected];
        std::vector<DifferingField> fields;
        std::size_t next = 0;
        const auto compare = [&](const auto& mine, const auto& truth) {
            const std::string name(compared[next++]);
            if (!same(mine, truth, tolerance_)) fields.push_back({name, shown(mine), shown(truth)});
        };
        const bool both_cast = was_cast(got) == was_cast(expected);  // else one of them has little to compare
        compare(got.kind, expected.kind);
        compare(got.depth, expected.depth);
        if (both_cast)
            compare(convert<double>(got.ray.direction), convert<double>(expected.ray.direction));
        else
            ++next;
        compare(got.object, expected.object);
        compare(got.ended, expected.ended);
        if (!both_cast) return fields;
        compare(got.t, expected.t);
        compare(got.point, expected.point);
        compare(got.normal, expected.normal);
        compare(got.throughput, expected.throughput);
        compare(got.local, expected.local);
        compare(got.contribution, expected.contribution);
        if (!fields.empty()) add_shadow_rays(pair, fields);
        return fields;
    }

    // A local colour is wrong for a reason where a shadow ray below it is.
    void add_shadow_rays(const Pair& pair, std::vector<DifferingField>& fields) const {
        for (const auto& [got, expected] : matched_children(pair).matched) {
            const RayNode &mine = got_.nodes[got], &truth = expected_.nodes[expected];
            if (mine.kind == RayKind::shadow && mine.ended != truth.ended)
                fields.push_back(
                    {fmt::format("shadow ray to light {}", truth.light), shown(mine.ended), shown(truth.ended)});
        }
    }

    Children matched_children(const Pair& pair) const {
        Children result;
        std::vector<std::size_t> left = got_below_[pair.got];
        for (const std::size_t expected : expected_below_[pair.expected]) {
            const auto& truth = expected_.nodes[expected];
            const auto alike = std::ranges::find_if(left, [&](std::size_t i) {
                return got_.nodes[i].kind == truth.kind && got_.nodes[i].light == truth.light;
            });
            if (alike != left.end()) {
                result.matched.push_back({*alike, expected});
                left.erase(alike);
            } else if (!result.unpaired) {
                result.unpaired = unpaired(RayTreeDifference::In::expected, {pair.got, expected});
            }
        }
        if (!left.empty() && !result.unpaired)
            result.unpaired = unpaired(RayTreeDifference::In::got, {left.front(), pair.expected});
        return result;
    }

    RayTreeDifference unpaired(RayTreeDifference::In in, const Pair& pair) const {
        const bool is_got = in == RayTreeDifference::In::got;
        const RayTree& tree = is_got ? got_ : expected_;
        const std::size_t node = is_got ? pair.got : pair.expected;
        const std::string there = to_string(tree.nodes[node].kind) + " ray", none = "none";
        return {in,
                pair.got,
                pair.expected,
                {{"branch", is_got ? there : none, is_got ? none : there}},
                place_of(tree, node)};
    }

    // "the eye ray's reflected ray"; of great-grandchildren and what is below them "the reflected ray below eye,
    // transmitted, ...".
    static std::string place_of(const RayTree& tree, std::size_t node) {
        constexpr std::size_t max_generations = 20;
        const auto name = [&](std::size_t i) {
            const RayNode& n = tree.nodes[i];
            return n.kind == RayKind::shadow ? fmt::format("shadow ray to light {}", n.light)
                                             : to_string(n.kind) + " ray";
        };
        std::vector<std::string> above;  // kinds, the nearest first
        for (std::size_t i = tree.nodes[node].parent; i != RayNode::none; i = tree.nodes[i].parent)
            above.push_back(to_string(tree.nodes[i].kind));
        if (above.empty()) return "the " + name(node);
        if (above.size() == 1) return "the eye ray's " + name(node);
        const bool all = above.size() <= max_generations;
        above.resize(std::min(above.size(), max_generations));
        return fmt::format("the {} below {}{}", name(node), all ? "" : "..., ",
                           fmt::join(above.rbegin(), above.rend(), ", "));
    }

    const RayTree &got_, &expected_;
    const std::vector<std::vector<std::size_t>> got_below_, expected_below_;
    const RayTreeTolerance tolerance_;
};

}  // namespace

std::optional<RayTreeDifference> first_difference(const RayTree& got, const RayTree& expected,
                                                  const RayTreeTolerance& tolerance) {
    return Comparison(got, expected, tolerance).first();
}

std::string to_string(const RayTreeDifference& difference) {
    std::string text = "the first node that differs is " + difference.place + ":";
    for (const auto& [name, got, expected] : difference.fields)
        text += fmt::format("\n  {} expected {}, got {}", name, printable(expected), printable(got));
    return text;
}

}  // namespace raylab
