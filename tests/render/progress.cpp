#include "catch.h"
#include "render/program.h"

#include "raylab/base/file.h"
#include "raylab/image/picture_files/files.h"
#include "raylab/image/picture_files/sampled_files.h"

#include <fmt/format.h>

#include <cmath>

// Pictures of spread rays grow: they are resumed, made in parts, and ended by an error or a time.

using namespace raylab;
using namespace raylab::test;

namespace {

/// The largest difference of any channel, in units of the last place of floats.
double ulps_apart(const std::filesystem::path& a, const std::filesystem::path& b) {
    const Image one = read_sampled(a).image.mean(), other = read_sampled(b).image.mean();
    double most = 0;
    const auto apart = [&](float x, float y) {
        const float next = std::nextafter(std::abs(x), 2 * std::abs(x) + 1);
        most = std::max(most, std::abs(double{x} - double{y}) / (double{next} - std::abs(double{x})));
    };
    for (std::size_t i = 0; i < one.pixels().size(); ++i) {
        const Pixel &p = one.pixels()[i], &q = other.pixels()[i];
        apart(p.r, q.r);
        apart(p.g, q.g);
        apart(p.b, q.b);
    }
    return most;
}

}  // namespace

TEST_CASE("a picture of spread rays is the same bits on one thread and on four") {
    for (const std::string model : {"distributed", "path"}) {
        const auto one = drawn("one_thread.exr", {"--model", model, "--samples", "8", "--threads", "1"});
        const auto four = drawn("four_threads.exr", {"--model", model, "--samples", "8", "--threads", "4"});
        CHECK(same_bits(one, four));
    }
}

TEST_CASE("a picture that was stopped and resumed is the same bits as one that was not") {
    const auto whole = drawn("whole.exr", {"--size", "120x90", "--samples", "512", "--model", "path"});
    const auto stopped = written("stopped.exr");
    std::filesystem::remove(stopped);
    // It is stopped when it has stored a picture for the first time, after two seconds.
    const std::string command = std::string(RAYLAB_BUILD "/raylab render ") + spread_scene() + " -o " +
                                stopped.string() +
                                " --size 120x90 --samples 512 --model path --threads 1 & p=$!; "
                                "while [ ! -s " +
                                stopped.string() + " ]; do sleep 0.05; done; kill -TERM $p; wait $p";
    const ProcessResult result = run_process("/bin/sh", {"-c", command}, {.timeout = 120});
    INFO(result.errors);
    const auto samples = read_sampled(stopped).image.at(0, 0).count;
    CHECK(result.errors.find(fmt::format("of 512 samples; {} are stored; --resume goes on with them\n", samples)) !=
          std::string::npos);
    CHECK(samples > 0);
    REQUIRE(samples < 512);
    CHECK_FALSE(same_bits(whole, stopped));
    drawn("stopped.exr", {"--size", "120x90", "--samples", "512", "--model", "path", "--resume"});
    CHECK(same_bits(whole, stopped));
}

TEST_CASE("parts that are merged, in any order, are within one ulp of the whole") {
    const std::vector<std::string> how{"--model", "path", "--samples", "30"};
    const auto whole = drawn("all.exr", how);
    std::vector<std::string> words{"merge"};
    for (const std::string part : {"3/4", "1/4", "4/4", "2/4"}) {
        auto options = how;
        options.insert(options.end(), {"--part", part});
        words.push_back(drawn("part_" + part.substr(0, 1) + ".exr", options).string());
    }
    const auto sum = written("sum.exr");
    words.insert(words.end(), {"-o", sum.string()});
    const ProcessResult result = ran(words);
    INFO(result.errors);
    REQUIRE(result.succeeded());
    CHECK(read_sampled(sum).image.at(3, 3).count == 30);
    CHECK(ulps_apart(whole, sum) <= 1);
    // One part alone is another picture.
    CHECK(ulps_apart(whole, written("part_1.exr")) > 1);
}

TEST_CASE("--error goes on until the expected error is below it, --time ends near its time") {
    const auto rough = read_sampled(drawn("rough.exr", {"--error", "0.2"})).image;
    const auto fine = read_sampled(drawn("fine.exr", {"--error", "0.02"})).image;
    CHECK(rough.relative_error() < 0.2);
    CHECK(fine.relative_error() < 0.02);
    CHECK(fine.at(0, 0).count > rough.at(0, 0).count);
    CHECK(rough.at(0, 0).count >= 8);  // randomisations: fewer say nothing

    const auto begun = std::chrono::steady_clock::now();
    drawn("timed.exr", {"--time", "1s"});
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    CHECK(seconds > 0.3);
    CHECK(seconds < 5);
}

TEST_CASE("--adaptive spends as many samples in all, more of them where it is noisy") {
    const auto image = read_sampled(drawn("adaptive.exr", {"--samples", "64", "--adaptive"})).image;
    double sum = 0;
    std::uint32_t most = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            sum += image.at(x, y).count;
            most = std::max(most, image.at(x, y).count);
        }
    CHECK(sum <= 64.0 * image.width() * image.height());
    CHECK(most > 64);
}

TEST_CASE("paths end in a closed room that absorbs nothing, by the diffuse lobe and between mirrors") {
    const std::string room = R"(raylab = 1
[image]
width = 4
height = 3
[material.white]
diffuse = [1, 1, 1]
[material.mirror]
diffuse = [0, 0, 0]
kr = 1
[[shape]]
type = "sphere"
center = [0, 0, -3]
radius = 2
material = "mirror"
[[shape]]
type = "sphere"
center = [0, 0, 0]
radius = 9
material = )";
    const auto file = written("room.toml");
    const auto ends = [&](const std::string& wall, const std::string& model) {
        write_file(file, room + wall);
        return run_process(std::filesystem::path(RAYLAB_BUILD) / "raylab",
                           {"render", file.string(), "--model", model, "--samples", "2", "--json", "-"},
                           {.timeout = 60})
            .succeeded();
    };
    CHECK(ends("\"white\"", "path"));
    CHECK(ends("\"mirror\"", "path"));
    CHECK(ends("\"mirror\"", "distributed"));
}

TEST_CASE("the file says which picture it is: seed, command, samples, and the variance of the mean") {
    const auto file = read_sampled(drawn("said.exr", {"--samples", "16", "--seed", "7", "--sampler", "halton"}));
    CHECK(file.texts.at("raylab_seed") == "7");
    CHECK(file.texts.at("raylab_samples") == "0-16");
    CHECK(file.texts.at("raylab_picture").find("halton") != std::string::npos);
    CHECK(file.texts.at("raylab_command").starts_with("raylab render "));
    CHECK(file.image.variance_of_mean(12, 12) > 0);
}

TEST_CASE("through a FIFO goes the finished picture alone, whose reader ends with the first writer") {
    const auto fifo = written("fifo.png"), got = written("got.png");
    std::filesystem::remove(fifo);
    // Longer than the two seconds after which a picture that replaces a file is stored for the first time.
    const std::string command = "mkfifo " + fifo.string() + "; cat " + fifo.string() + " > " + got.string() +
                                " & timeout 30 " RAYLAB_BUILD "/raylab render " + spread_scene() + " -o " +
                                fifo.string() + " --time 4s --threads 1; code=$?; wait; exit $code";
    const ProcessResult result = run_process("/bin/sh", {"-c", command}, {.timeout = 60});
    INFO(result.errors);
    CHECK(result.code == 0);
    CHECK(read_image(got).width() == 24);
}

TEST_CASE("an interrupt says that nothing is stored where a picture is only counted") {
    const std::string command = "timeout -s TERM 4 " RAYLAB_BUILD "/raylab render " + spread_scene() +
                                " --json - --time 60s --threads 1; exit 0";
    CHECK_THAT(run_process("/bin/sh", {"-c", command}, {.timeout = 60}).errors, Catch::Contains("; none is stored\n"));
}

TEST_CASE("a finished picture that is resumed casts no rays, and says so in numbers") {
    drawn("finished.exr", {"--samples", "4"});
    const auto again =
        ran({"render", spread_scene(), "-o", written("finished.exr").string(), "--samples", "4", "--resume"});
    CHECK_THAT(again.output, Catch::StartsWith("0 eye rays, 0 shadow rays, 0 others in 0 s: 0 rays a second\n"));
}

TEST_CASE("a picture whose rays end at no depth says \"any depth\", one whose rays do says which") {
    CHECK_THAT(read_sampled(drawn("any_depth.exr", {"--samples", "2"})).texts.at("raylab_picture"),
               Catch::Contains(", any depth, "));
    CHECK_THAT(read_sampled(drawn("depth.exr", {"--samples", "2", "--depth", "3"})).texts.at("raylab_picture"),
               Catch::Contains(", depth 3, "));
    CHECK_THAT(ran({"render", "--help"}).output, Catch::Contains("any where rays are spread"));
}
