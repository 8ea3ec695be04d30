#include "commands.h"
#include "memory_words.h"
#include "picture_words.h"
#include "pixel_inset.h"
#include "transport_words.h"
#include "tree_difference.h"

#include "raylab/base/command_line.h"
#include "raylab/base/common_options.h"
#include "raylab/base/error.h"
#include "raylab/base/outputs.h"
#include "raylab/base/printable.h"
#include "raylab/report/json_text.h"
#include "raylab/report/ray_tree/folded_tree.h"
#include "raylab/report/ray_tree/ray_tree_diagram.h"
#include "raylab/report/ray_tree/ray_tree_json.h"
#include "raylab/report/ray_tree/ray_tree_words.h"
#include "raylab/scene/memory_need.h"
#include "raylab/tracer/picture/whitted_picture.h"
#include "raylab/transport/path/transport_picture.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>

namespace raylab {

namespace {

const CommandLine tree_command_line = with_sampler_options(with_picture_options(
    {.program = "raylab tree",
     .about = "Draws the tree of all rays of a pixel, or writes it as data, or tells where two trees differ. With "
              "--against,\n"
              "exit code 0: the same, 1: they differ, 2: one of them cannot be read.",
     .positionals = {{"SCENE", "the scene (.toml, .nff), or a tree as data (.json)"}},
     .options = {
         {"--pixel", "X,Y",
          "the pixel of the picture that `raylab render` draws with these options; 0,0 is at the upper left"},
         {"--sample", "K",
          "the index of the sample among the pixel's, from 0 (default: 0; of spread rays all, folded into one tree)"},
         {"-o,--output", "FILE", "the file to write: .dot .svg .png .pdf .json"},
         {"--against", "B.json", "compare SCENE's tree with this one; the first node that differs is red"},
         {"--shadow-rays", "", "draw the shadow rays, too"},
         {"--prune", "SHARE",
          "combine branches whose throughput is not above this; 0: none (default: the 40 rays of largest "
          "throughput are drawn)"},
         {"--json", "FILE", "the tree, or the difference, as JSON; - is standard output"}}}));

// Reads "31,20", column and row; the pixel must be inside the picture.
std::array<int, 2> pixel_from(const std::string& words, ImageSize image) {
    const auto pixel = two_integers(words, ',');
    if (!pixel || (*pixel)[0] >= image.width || (*pixel)[1] >= image.height)
        throw Error(
            fmt::format("expected --pixel X,Y inside {} x {} pixels, found \"{}\"", image.width, image.height, words));
    return *pixel;
}

struct NamedTree {
    RayTree tree;
    std::string title;
    // Of a tree that was read these are not known.
    std::string recursion_ends = {};  // where, in words
    std::string inset = {};           // a picture that shows the pixel, where a diagram of this tree alone is drawn
};

std::string title_of(const AskedPicture& picture, const PixelSample& sample) {
    const auto name = std::filesystem::path(picture.scene.source).filename().string();
    if (picture.samples.count() == 1) return fmt::format("Pixel ({}, {}) of {}", sample.x, sample.y, name);
    return fmt::format("Sample {} of pixel ({}, {}) of {}", sample.number, sample.x, sample.y, name);
}

// Numbers the lights as the scene's file does, including those that have no effect and were left out.
RayTree with_lights_named(RayTree tree, const std::vector<std::size_t>& lights) {
    for (RayNode& node : tree.nodes)
        if (node.light != RayNode::none) node.light = lights[node.light];
    return tree;
}

bool draws_diagram(const Arguments& arguments) {
    return arguments.has("--output") && !arguments.has("--against") &&
           std::filesystem::path(arguments.text("--output")).extension() != ".json";
}

Diagram with_inset(Diagram diagram, const std::string& png) {
    diagram.inset = png;
    return diagram;
}

// One sample of a pixel, or all of them folded into one tree.
NamedTree tree_of_spread_rays(const Arguments& arguments, const AskedScene& asked) {
    const Scene& scene = asked.scene;
    refuse_whitted_words(arguments);
    const AskedTransport how = asked_sampler(arguments, scene);
    check_memory(accelerator_need(scene), asked.limit, {scene.source});
    const auto [x, y] = pixel_from(arguments.text("--pixel"), scene.image);
    const CameraFrame frame = camera_frame(scene.camera, scene.image, scene.source);
    const auto accelerator = make_accelerator(arguments.text("--accelerator"), scene);
    const TransportPicture picture(scene, *accelerator, frame, how.options, how.filter);
    const std::string pixel =
        fmt::format("pixel ({}, {}) of {}", x, y, std::filesystem::path(scene.source).filename().string());
    if (arguments.has("--sample")) {
        const auto sample = static_cast<int>(arguments.integer("--sample", 0, how.sampler.count - 1));
        return {picture.tree(how.sampler, x, y, sample), fmt::format("Sample {} of {}", sample, pixel)};
    }
    std::vector<RayTree> trees;
    for (int i = 0; i < how.sampler.count; ++i) trees.push_back(picture.tree(how.sampler, x, y, i));
    return {folded_tree(trees), fmt::format("{} samples of {}", how.sampler.count, pixel)};
}

NamedTree tree_of_scene(const Arguments& arguments, Outputs& outputs) {
    AskedScene asked = asked_scene(arguments, outputs);
    if (asked.scene.model != RenderModel::whitted) return tree_of_spread_rays(arguments, asked);
    refuse_sampler_words(arguments);
    const AskedPicture picture = asked_picture(arguments, std::move(asked));
    check_memory(accelerator_need(picture.scene), picture.limit, {picture.scene.source});
    const auto [x, y] = pixel_from(arguments.text("--pixel"), picture.frame.image);
    const int number =
        arguments.has("--sample") ? static_cast<int>(arguments.integer("--sample", 0, picture.samples.count() - 1)) : 0;
    const PixelSample sample{x, y, number};
    const PictureAccelerator accelerator = picture_accelerator(arguments, picture, 1);
    RayTree tree =
        sample_tree(picture.scene, accelerator.finds(), picture.frame, picture.options, picture.samples, sample);
    return {with_lights_named(std::move(tree), picture.lights), title_of(picture, sample),
            recursion_words(picture) + "\n", draws_diagram(arguments) ? pixel_inset(picture, sample) : ""};
}

NamedTree tree_of(const Arguments& arguments, Outputs& outputs) {
    const std::filesystem::path from = arguments.text("SCENE");
    if (from.extension() == ".json")
        return {read_ray_tree(from, memory_limit(arguments)), from.filename().string(), {}, {}};
    return tree_of_scene(arguments, outputs);
}

RayTreeView view_of(const Arguments& arguments) {
    RayTreeView view;
    if (arguments.has("--shadow-rays")) view.shadow_rays = RayTreeView::ShadowRays::shown;
    if (!arguments.has("--prune")) return view;
    view.prune = arguments.number("--prune");
    if (!(*view.prune >= 0 && *view.prune < 1))
        throw Error("expected --prune from 0 to below 1, found " + arguments.text("--prune"));
    return view;
}

}  // namespace

ExitCode tree_command(const std::vector<std::string>& words) {
    const auto arguments = parse(tree_command_line, words);
    const auto output = arguments.text_if_given("--output"), json = arguments.text_if_given("--json");
    const auto view = view_of(arguments);
    if (!output && !json && !arguments.has("--against")) throw Error("expected -o FILE or --json FILE, found neither");
    if (output && std::filesystem::path(*output).extension() != ".json") check_diagram_name(*output);
    Outputs outputs(
        {.files = arguments.given({"--output", "--json"}), .inputs = arguments.given({"SCENE", "--against"})});
    const auto [tree, title, recursion_ends, inset] = tree_of(arguments, outputs);
    if (const auto against = arguments.text_if_given("--against"))
        return report_difference({.got = tree,
                                  .got_title = title,
                                  .expected = read_ray_tree(*against, memory_limit(arguments)),
                                  .expected_title = *against,
                                  .view = view},
                                 output, json, outputs);
    if (json) write_json(json_text(to_json(tree)), outputs[*json]);
    if (output && std::filesystem::path(*output).extension() == ".json")
        write_json(json_text(to_json(tree)), outputs[*output]);
    else if (output)
        write_diagram(with_inset(ray_tree_diagram(tree, title + "\n" + summary(tree), view), inset), outputs[*output]);
    if (json != "-") outputs.say(printable(title) + ": " + summary(tree) + "\n" + recursion_ends);
    outputs.commit();
    return ExitCode::as_it_should_be;
}

}  // namespace raylab
