#include "catch.h"

#include "traced_numbers.h"
#include "tracer/is_textbook.h"

#include "raylab/experiment/textbook/textbook.h"
#include "raylab/report/json_text.h"
#include "raylab/report/ray_tree/ray_tree_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>

using namespace raylab;
using namespace raylab::grading;

namespace {

// A pixel's tree as a student's process sends it.
std::vector<double> said(const TracedScene& traced, int x, int y) {
    std::vector<double> numbers(traced_outputs);
    const auto node = [&](std::size_t i) {
        const double input[] = {1.0 * x, 1.0 * y, 1.0 * static_cast<double>(i)};
        std::vector<double> output(traced_outputs);
        write_traced(traced, input, output);
        return output;
    };
    const std::size_t count = traced_nodes_of(node(0));
    numbers.clear();
    for (std::size_t i = 0; i < count; ++i) std::ranges::copy(node(i), std::back_inserter(numbers));
    return numbers;
}

}  // namespace

TEST_CASE("the traced scene is one that the textbook knows, and every matter and every ending shows in it") {
    const auto traced = traced_scene();
    REQUIRE(test::is_textbook(traced.scene));
    std::set<std::string> objects;
    std::set<Ending> endings;
    for (int y = 0; y < traced_size.height; y += 2)
        for (int x = 0; x < traced_size.width; x += 2)
            for (const auto& node : traced.tree(x, y).nodes) {
                objects.insert(node.object);
                endings.insert(node.ended);
            }
    CHECK(objects ==
          std::set<std::string>{"", "balloon", "floor", "glass sphere", "mirror sphere", "prism", "red sphere"});
    CHECK(endings.size() == 7);  // all except the threshold, which the textbook's tracer does not have
}

TEST_CASE("a ray tree crosses the pipe as it is") {
    const auto traced = traced_scene();
    for (const auto& [x, y] : {std::pair{70, 30}, {20, 30}, {3, 3}, {48, 60}}) {
        const auto back = traced_tree(traced, said(traced, x, y));
        REQUIRE(back);
        CHECK(json_text(to_json(*back)) == json_text(to_json(traced.tree(x, y))));
    }
}

TEST_CASE("what is no tree is not believed") {
    const auto traced = traced_scene();
    const auto numbers = said(traced, 70, 30);
    REQUIRE(traced_tree(traced, numbers));
    const auto refused = [&](std::size_t place, double value) {
        auto wrong = numbers;
        wrong[traced_outputs + place] = value;  // a field of the second node
        return !traced_tree(traced, wrong);
    };
    for (const double value : {-2.0, 0.5, 1e9, std::nan(""), double(INFINITY)})
        for (const std::size_t whole : {4, 5, 6, 7, 8, 9}) {  // kind, ended, parent, light, object, depth
            INFO(whole << " " << value);
            if (whole != 9 || value != -2.0) CHECK(refused(whole, value));
        }
    CHECK(refused(4, 4));  // there are four kinds
    CHECK(refused(5, 9));  // and nine endings
    CHECK(refused(7, static_cast<double>(traced.scene.lights.size())));
    CHECK(refused(8, static_cast<double>(traced.scene.objects.size())));
    CHECK(refused(6, 1));   // its own parent
    CHECK(refused(6, -1));  // a second eye ray
    CHECK_FALSE(traced_tree(traced, {}));
    CHECK_FALSE(traced_tree(traced, std::span(numbers).first(30)));
    CHECK(traced_nodes_of(std::vector<double>(traced_outputs, std::nan(""))) == 0);
    CHECK(traced_nodes_of(std::vector<double>(traced_outputs, 1e300)) == 0);
}
