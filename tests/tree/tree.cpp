#include "catch.h"
#include "could_not.h"

#include "raylab/base/file.h"
#include "raylab/base/process.h"
#include "raylab/image/picture_files/files.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <filesystem>

// Tests of `raylab tree` from outside.

namespace fs = std::filesystem;
using raylab::ProcessResult;

namespace {

const fs::path folder = fs::path(RAYLAB_BUILD) / "tests/tree";
const std::string scene = RAYLAB_SOURCE "/tests/bench/mirror_and_glass.toml";

ProcessResult tree(std::vector<std::string> words) {
    words.insert(words.begin(), "tree");
    return raylab::run_process(fs::path(RAYLAB_BUILD) / "raylab", words, {.timeout = 60});
}

std::string tree_file(const std::string& name, const std::string& depth) {
    const auto file = (folder / name).string();
    REQUIRE(tree({scene, "--pixel", "300,250", "--depth", depth, "-o", file}).succeeded());
    return file;
}

}  // namespace

TEST_CASE("raylab tree writes each format, and what is said on the way is a line") {
    for (const std::string extension : {"dot", "svg", "png", "pdf", "json"}) {
        const auto file = folder / ("a." + extension);
        fs::remove(file);
        const auto result = tree({scene, "--pixel", "300,250", "-o", file.string()});
        INFO(result.errors);
        CHECK(result.succeeded());
        CHECK(fs::file_size(file) > 200);
        CHECK(result.output.starts_with("Pixel (300, 250) of mirror_and_glass.toml: "));
    }
    const auto json = nlohmann::json::parse(raylab::read_file(folder / "a.json"));
    CHECK(json["nodes"][0]["kind"] == "eye");
    CHECK(nlohmann::json::parse(tree({scene, "--pixel", "300,250", "--json", "-"}).output) == json);
}

TEST_CASE("the trees of a pixel's samples make the pixel that render draws with the same options") {
    for (const std::vector<std::string>& options :
         std::vector<std::vector<std::string>>{{},
                                               {"--depth", "4"},
                                               {"--accelerator", "kd", "--fresnel"},
                                               {"--item-buffer", "always", "--offset", "fixed:0.01"},
                                               {"--spd"}}) {
        std::vector<std::string> words{scene, "--size", "32x24", "--samples", "2x2"};
        words.insert(words.end(), options.begin(), options.end());
        const auto picture = (folder / "samples.exr").string();
        auto drawing = words;
        drawing.insert(drawing.begin(), "render");
        drawing.insert(drawing.end(), {"-o", picture});
        REQUIRE(raylab::run_process(fs::path(RAYLAB_BUILD) / "raylab", drawing, {.timeout = 60}).succeeded());
        std::array<double, 3> sum{};
        for (int sample = 0; sample < 4; ++sample) {
            auto asking = words;
            asking.insert(asking.end(), {"--pixel", "20,15", "--sample", std::to_string(sample), "--json", "-"});
            const auto json = nlohmann::json::parse(tree(asking).output);
            for (std::size_t i = 0; i < 3; ++i) sum[i] += json["pixel"][i].get<double>();
        }
        const raylab::Pixel pixel = raylab::read_image(picture).at(20, 15);
        CHECK(pixel.r == static_cast<float>(sum[0] / 4));
        CHECK(pixel.g == static_cast<float>(sum[1] / 4));
        CHECK(pixel.b == static_cast<float>(sum[2] / 4));
    }
}

TEST_CASE("shadow rays and pruned branches show in the diagram, all numbers in its tooltips") {
    const auto drawn = [](const std::vector<std::string>& more) {
        const auto file = (folder / "drawn.svg").string();
        std::vector<std::string> words{scene, "--pixel", "300,250", "-o", file};
        words.insert(words.end(), more.begin(), more.end());
        REQUIRE(tree(words).succeeded());
        return raylab::read_file(file);
    };
    const auto plain = drawn({});
    CHECK(plain.find("xlink:title=\"eye ray, depth 1, throughput 1") != std::string::npos);
    CHECK(plain.find("local colour (") != std::string::npos);
    CHECK(plain.find("to light 0") == std::string::npos);
    CHECK(drawn({"--shadow-rays"}).find("to light 0") != std::string::npos);
    CHECK(plain.find("pruned") == std::string::npos);
}

TEST_CASE("an SVG and a PNG hold a small picture in which the pixel is ringed, a .dot file does not") {
    const auto drawn = [](const std::string& pixel, const std::string& extension) {
        const auto file = (folder / ("inset" + extension)).string();
        REQUIRE(tree({scene, "--pixel", pixel, "--depth", "1", "-o", file}).succeeded());
        return raylab::read_file(file);
    };
    const auto inset = [&](const std::string& pixel) {
        const auto svg = drawn(pixel, ".svg");
        const auto from = svg.find("\"data:image/png;base64,iVBORw0KGgo");
        REQUIRE(from != std::string::npos);
        return svg.substr(from, svg.find('"', from + 1) - from);
    };
    CHECK(inset("300,250") == inset("300,250"));
    CHECK(inset("300,250") != inset("30,20"));
    drawn("300,250", ".png");
    // The floor of the small picture; nothing else is red.
    const auto is_red = [](const raylab::Pixel& pixel) { return pixel.r > 0.2f && pixel.r > 4 * pixel.b; };
    CHECK(std::ranges::any_of(raylab::read_image(folder / "inset.png").pixels(), is_red));
    CHECK(drawn("300,250", ".dot").find("inset") == std::string::npos);
}

TEST_CASE("a tree is compared with another: 0 the same, 1 they differ, and where") {
    const auto a = tree_file("deep.json", "5"), b = tree_file("flat.json", "1");
    CHECK(tree({a, "--against", a}).code == 0);
    raylab::write_file(folder / "other.json", [&] {
        auto json = nlohmann::ordered_json::parse(raylab::read_file(a));
        json["nodes"][0]["local"][0] = 7;
        return json.dump();
    }());
    const auto picture = folder / "difference.svg";
    fs::remove(picture);
    const auto result = tree({(folder / "other.json").string(), "--against", a, "-o", picture.string(), "--json",
                              (folder / "difference.json").string()});
    CHECK(result.code == 1);
    CHECK(result.output.find("the first node that differs is the eye ray:\n  local colour expected") == 0);
    CHECK(raylab::read_file(picture).find("FIRST DIFFERENCE") != std::string::npos);
    const auto as_data = [](const fs::path& file) { return nlohmann::json::parse(raylab::read_file(file)); };
    CHECK(as_data(folder / "difference.json")["place"] == "the eye ray");
    const auto output = folder / "difference_as_output.json";
    CHECK(tree({(folder / "other.json").string(), "--against", a, "-o", output.string()}).code == 1);
    CHECK(as_data(output) == as_data(folder / "difference.json"));
    CHECK(tree({scene, "--pixel", "300,250", "--depth", "5", "--against", a}).code == 0);
}

TEST_CASE("raylab tree refuses what it cannot do, and says why") {
    check_could_not(tree({scene, "--pixel", "300,250"}), "expected -o FILE or --json FILE, found neither");
    check_could_not(tree({scene, "--pixel", "99999,1", "-o", "x.svg"}), "expected --pixel X,Y inside");
    check_could_not(tree({scene, "--pixel", "3", "-o", "x.svg"}), "expected --pixel X,Y inside");
    check_could_not(tree({scene, "-o", "x.svg"}), "--pixel");
    check_could_not(tree({scene, "--pixel", "1,1", "--samples", "2x2", "--sample", "4", "-o", "x.svg"}), "--sample");
    check_could_not(tree({scene, "--pixel", "1,1", "-o", "x.gif"}), "expected a diagram to end in");
    check_could_not(tree({scene, "--pixel", "1,1", "--prune", "2", "-o", "x.svg"}),
                    "expected --prune from 0 to below 1, found 2");
    raylab::write_file(folder / "broken.json", "{\"raylab\": ");
    check_could_not(tree({(folder / "broken.json").string(), "--against", scene}), "broken.json");
    const std::size_t depth = 100'000;
    raylab::write_file(folder / "deep.json", "{\"raylab\": " + std::string(depth, '[') + std::string(depth, ']') + "}");
    check_could_not(tree({tree_file("deep_against.json", "5"), "--against", (folder / "deep.json").string()}),
                    "nested at most 64 deep");
    check_could_not(tree({(folder / "none.json").string(), "--against", scene}), "none.json");
}

TEST_CASE("the trees of a pixel's paths add up to the pixel that render draws, and so does the folded tree") {
    const std::string spread = RAYLAB_SOURCE "/chapters/15_distributed/scenes/colonnade.toml";
    const auto picture = (folder / "paths.exr").string();
    const std::vector<std::string> how{"--size", "32x20", "--samples", "4"};
    std::vector<std::string> drawing{"render", spread, "-o", picture};
    drawing.insert(drawing.end(), how.begin(), how.end());
    REQUIRE(raylab::run_process(fs::path(RAYLAB_BUILD) / "raylab", drawing, {.timeout = 60}).succeeded());
    const raylab::Pixel pixel = raylab::read_image(picture).at(18, 15);
    const auto asked = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words{spread, "--pixel", "18,15", "--json", "-"};
        words.insert(words.end(), how.begin(), how.end());
        words.insert(words.end(), more.begin(), more.end());
        return nlohmann::json::parse(tree(words).output);
    };
    double sum = 0, contributions = 0;
    std::size_t densities = 0;
    for (int sample = 0; sample < 4; ++sample) {
        const auto json = asked({"--sample", std::to_string(sample)});
        sum += json["pixel"][0].get<double>() / 4;
        for (const auto& node : json["nodes"]) {
            if (node["kind"] != "shadow") contributions += node["contribution"][0].get<double>() / 4;
            densities += node.contains("density");
        }
    }
    CHECK(sum == Approx(pixel.r).epsilon(1e-6));
    CHECK(contributions == Approx(pixel.r).epsilon(1e-6));
    CHECK(densities > 0);
    const auto folded = asked({});
    CHECK(folded["pixel"][0].get<double>() == Approx(pixel.r).epsilon(1e-6));
    CHECK(folded["nodes"][0]["object"] == "the pixel");
    double of_folded = 0;
    for (const auto& node : folded["nodes"])
        if (node["kind"] != "shadow") of_folded += node["contribution"][0].get<double>();
    CHECK(of_folded == Approx(pixel.r).epsilon(1e-6));
}
