#include "raylab/report/diagram/diagram.h"

#include "catch.h"
#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/base/process.h"
#include "raylab/report/diagram/diagram_text.h"
#include "sanitized.h"

#include <unistd.h>

#include <filesystem>
#include <thread>

using namespace raylab;
namespace fs = std::filesystem;

namespace {

struct Folder {
    fs::path path = fs::temp_directory_path() / ("raylab_diagram_" + std::to_string(getpid()));
    Folder() { fs::create_directories(path); }
    ~Folder() { fs::remove_all(path); }
};

Diagram diagram(const std::string& label) {
    return {.title = "A <title> & \\N",
            .nodes = {{label, "tip"}, {"b", "", "ellipse", "#56b4e9", "dashed", 2}, {"c"}},
            .edges = {{0, 1, "edge \"1\""}, {0, 2, "", "#d55e00", "bold"}, {1, 2}}};
}

std::string drawn(const Diagram& what, const fs::path& file) {
    write_diagram(what, file);
    return read_file(file);
}

}  // namespace

TEST_CASE("the same diagram is the same bytes in every format and layout") {
    const Folder folder;
    for (const auto layout : {Diagram::Layout::layered, Diagram::Layout::radial})
        for (const std::string extension : {".dot", ".svg", ".png", ".pdf"}) {
            auto what = diagram("a");
            what.layout = layout;
            const auto first = drawn(what, folder.path / ("first" + extension));
            // Its date contains seconds.
            std::this_thread::sleep_for(std::chrono::milliseconds(extension == ".pdf" ? 1100 : 0));
            CHECK(first.size() > 100);
            CHECK(first == drawn(what, folder.path / ("second" + extension)));
        }
}

TEST_CASE("several threads draw at once, and each gets what it would get alone") {
    if (is_sanitized) {
        WARN("skipped: sanitizers are not made for threads in the copy of a process that has several");
        return;
    }
    const Folder folder;
    const auto alone = drawn(diagram("a"), folder.path / "alone.svg");
    std::vector<std::string> together(8);
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i < together.size(); ++i)
            threads.emplace_back([&, i] {
                for (int again = 0; again < 20; ++again)
                    together[i] = drawn(diagram("a"), folder.path / (std::to_string(i) + ".svg"));
            });
    }
    for (const auto& one : together) CHECK(one == alone);
}

TEST_CASE("a label is shown as it is: no backslash code, no entity, no HTML") {
    const Folder folder;
    const auto svg = drawn(diagram("\\N &lt; <b>\"x\"\nnext\x01"), folder.path / "a.svg");
    CHECK(svg.find("\\N &amp;lt; &lt;b&gt;&quot;x&quot;</text>") != std::string::npos);
    CHECK(svg.find(">next </text>") != std::string::npos);
    CHECK(svg.find("A &lt;title&gt; &amp; \\N") != std::string::npos);
}

TEST_CASE("DOT text reads back: what it draws is what we draw") {
    const Folder folder;
    drawn(diagram("quote \" back \\ slash"), folder.path / "a.dot");
    drawn(diagram("quote \" back \\ slash"), folder.path / "a.svg");
    if (find_program("dot").empty()) {
        WARN("skipped: no dot program here");
        return;
    }
    const auto result = run_process("dot", {"-Tsvg", folder.path / "a.dot"});
    CHECK(result.output == read_file(folder.path / "a.svg"));
}

TEST_CASE("another extension is refused, and nothing is written") {
    const Folder folder;
    CHECK_THROWS_AS(write_diagram(diagram("a"), folder.path / "a.gif"), Error);
    CHECK(fs::is_empty(folder.path));
}

TEST_CASE("an empty diagram is still a drawing") {
    const Folder folder;
    CHECK(drawn({.title = "nothing", .nodes = {}, .edges = {}}, folder.path / "a.svg").find("nothing") !=
          std::string::npos);
}
