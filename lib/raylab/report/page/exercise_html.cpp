#include "raylab/report/page/exercise_html.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/report/page/html.h"
#include "raylab/report/page/markdown.h"

namespace raylab {

namespace fs = std::filesystem;

namespace {

// The one file that a student edits: neither the program around it nor the judge.
fs::path stub_in(const fs::path& folder) {
    for (const auto& entry : fs::directory_iterator(folder)) {
        const auto name = entry.path().filename();
        if (name.extension() == ".cpp" && name != "main.cpp" && name != "judge.cpp") return entry.path();
    }
    throw Error({folder.string()}, "the file to write", "none");
}

std::string task_html(const fs::path& readme) {
    std::string html;
    const auto no_links = [](const std::string&) { return std::string(); };
    for (const auto& block : markdown_blocks(read_file(readme), no_links)) {
        if (block.kind != MarkdownBlock::Kind::heading)
            html += block.html;
        else if (block.level > 1)
            html += "<h4>" + block.html + "</h4>\n";
    }
    return html;
}

}  // namespace

std::string exercise_html(const fs::path& folder, const std::string& title) {
    const auto name = folder.filename().string();
    const auto number = name.substr(0, name.find('_'));
    const auto stub = stub_in(folder);
    return "<aside class=\"exercise\" id=\"exercise-" + number + "\"><h3>" + title + "</h3>\n<pre class=\"sh\"><code>" +
           "./raylab check " + number + "</code></pre>\n<details><summary>The task</summary>\n" +
           task_html(folder / "README.md") + "</details>\n<details><summary>The file to write: " +
           escape_html("exercises/" + name + "/" + stub.filename().string()) + "</summary><pre><code>" +
           escape_html(read_file(stub)) + "</code></pre></details></aside>\n";
}

}  // namespace raylab
