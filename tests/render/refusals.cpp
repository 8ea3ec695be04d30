#include "catch.h"
#include "could_not.h"
#include "render/program.h"

#include "raylab/base/file.h"
#include "raylab/image/picture_files/sampled_files.h"

using namespace raylab;
using namespace raylab::test;

namespace {

ProcessResult render(std::vector<std::string> options) {
    options.insert(options.begin(), {"render", spread_scene(), "-o", written("refused.exr").string()});
    return ran(options);
}

// The scene with something else in it, and what rendering it says.
ProcessResult render_with(const std::string& name, const std::string& more, std::vector<std::string> options = {}) {
    const auto file = written(name);
    write_file(file, read_file(spread_scene()) + more);
    options.insert(options.begin(), {"render", file.string(), "-o", written("refused.exr").string()});
    return ran(options);
}

}  // namespace

TEST_CASE("numbers of samples that are none are refused, and so are ends that do not go together") {
    check_could_not(render({"--samples", "0"}), "expected --samples from 1 to 1048576, found 0");
    check_could_not(render({"--samples", "2147483648"}), "expected --samples from 1 to 1048576, found 2147483648");
    check_could_not(render({"--samples", "-3"}), "--samples");
    check_could_not(render({"--samples", "4", "--error", "0.1"}),
                    "expected one of --samples, --error and --time, found 2");
    check_could_not(render({"--error", "0"}), "expected --error above 0 and below 1, found 0");
    check_could_not(render({"--time", "10"}), "expected --time with its unit (10s, 2min, 1h), found \"10\"");
    check_could_not(render({"--sampler", "soboll"}), "soboll");
    check_could_not(render({"--filter", "bx"}), "expected --filter box, tent, gaussian, mitchell, found \"bx\"");
    check_could_not(render({"--part", "0/4"}), "expected --part I/N, I from 1 to N, found \"0/4\"");
    check_could_not(render({"--part", "5/4"}), "expected --part I/N, I from 1 to N, found \"5/4\"");
    check_could_not(render({"--part", "1/4", "--time", "1s"}), "expected --part with --samples");
    check_could_not(render({"--part", "1/8", "--samples", "4"}), "expected --part of at most 4 parts");
    check_could_not(render({"--model", "whitted", "--seed", "3"}), "expected --model distributed or path with --seed");
    check_could_not(render({"--adaptive", "--samples", "8"}),
                    "expected --samples of at least 16 with --adaptive, found 8");
    check_could_not(render({"--adaptive", "--error", "0.1"}), "expected --adaptive or --error, found both");
    check_could_not(render({"--model", "kajiya"}), "expected --model auto, whitted, distributed or path");
    check_could_not(render({"--threshold", "0.1"}), "expected --model whitted with --threshold 0.1");
    check_could_not(render({"--viewer", "infinity"}), "expected --model whitted with --viewer infinity");
    check_could_not(render({"--light-buffer", "always"}), "expected --model whitted with --light-buffer always");
    check_could_not(render({"--spd", "--model", "path"}), "expected --model whitted with --spd");
}

TEST_CASE("a light of no area is refused, by name") {
    check_could_not(render_with("flat_light.toml", R"(
[[shape]]
type = "triangle"
vertices = [[0, 1, 0], [1, 1, 0], [2, 1, 0]]
material = "light"
)"),
                    "expected a triangle with an area, found vertices on one line");
}

TEST_CASE("a light whose power overflows is refused, by name") {
    check_could_not(render_with("endless_light.toml", R"(
[material.endless]
emission = [1e308, 1e308, 1e308]
[[shape]]
type = "sphere"
center = [0, 9, 0]
radius = 1
material = "endless"
)"),
                    "a light whose area and emission give a finite power");
}

TEST_CASE("paths refuse materials that reflect more than they get") {
    check_could_not(render_with("too_white.toml", R"(
[material.too_white]
diffuse = [0.8, 0.8, 0.8]
kr = 0.5
[[shape]]
type = "sphere"
center = [2, 0.5, 0]
radius = 0.5
material = "too_white"
)",
                                {"--model", "path"}),
                    "material \"too_white\" with diffuse + kr + kt <= 1");
}

TEST_CASE("merge refuses parts of other scenes, seeds and numbers of samples, and the same part twice") {
    const std::vector<std::string> how{"--samples", "8", "--part", "1/2"};
    const auto part = drawn("half.exr", how).string();
    const auto with = [&](const std::string& name, std::vector<std::string> options) {
        return ran({"merge", part, drawn(name, std::move(options)).string(), "-o", written("refused.exr").string()});
    };
    check_could_not(with("other_seed.exr", {"--samples", "8", "--part", "2/2", "--seed", "9"}), "seed 9");
    check_could_not(with("other_count.exr", {"--samples", "16", "--part", "2/2"}), "samples 16");
    check_could_not(with("other_model.exr", {"--samples", "8", "--part", "2/2", "--model", "path"}), "path");
    check_could_not(with("other_start.exr", {"--samples", "8", "--part", "2/2", "--offset", "fixed:0.01"}),
                    "offset fixed:0.01");
    check_could_not(with("other_size.exr", {"--samples", "8", "--part", "2/2", "--size", "8x8"}), "");
    check_could_not(with("half_again.exr", how), "samples that no other part has");
    check_could_not(ran({"merge", "-o", written("refused.exr").string()}),
                    "expected the parts of a picture, found none");
    check_could_not(ran({"merge", part, "-o", written("refused.png").string()}), "a name ending in .exr");
    check_could_not(ran({"merge", part, written("missing.exr").string(), "-o", written("refused.exr").string()}),
                    "missing.exr");
}

TEST_CASE("--resume refuses the picture of another seed, and leaves it as it was") {
    const auto file = drawn("mine.exr", {"--samples", "4"});
    const std::string before = read_file(file);
    check_could_not(ran({"render", spread_scene(), "-o", file.string(), "--samples", "4", "--seed", "2", "--resume"}),
                    "samples of this picture");
    CHECK(read_file(file) == before);
}

TEST_CASE("--resume refuses sums of another size, whatever their file says of itself") {
    const auto file = drawn("cut.exr", {"--samples", "4"});
    write_sampled({SampledImage(23, 16), read_sampled(file).texts}, file);
    check_could_not(ran({"render", spread_scene(), "-o", file.string(), "--samples", "4", "--resume"}),
                    "cut.exr: expected a picture of 24 x 16 pixels, found 23 x 16");
}

TEST_CASE("merge names the file that is no part of a picture, the first as well as the second") {
    const auto part = drawn("good.exr", {"--samples", "8", "--part", "1/2"}), bare = written("bare.exr"),
               other = drawn("other.exr", {"--samples", "8", "--part", "2/2"});
    write_sampled({read_sampled(part).image, {}}, bare);
    const auto output = written("refused.exr").string();
    for (const std::vector<std::string>& files :
         {std::vector{bare.string(), other.string()}, {other.string(), bare.string()}, {bare.string()}}) {
        std::vector<std::string> words{"merge", "-o", output};
        words.insert(words.end(), files.begin(), files.end());
        check_could_not(ran(words), "bare.exr: expected a part of a picture, found no raylab_picture");
    }
}

TEST_CASE("merge keeps two pictures in memory, which together need no more than --memory") {
    const auto part = [](const std::string& number) {
        return drawn("large_" + number + ".exr", {"--samples", "2", "--size", "256x256", "--part", number + "/2"});
    };
    const auto first = part("1").string(), second = part("2").string(), output = written("large.exr").string();
    // 2.5 MiB, and 10.5 to read another.
    check_could_not(ran({"merge", first, second, "-o", output, "--memory", "12M"}), "large_2.exr: expected at most ");
}
