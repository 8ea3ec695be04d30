#include "raylab/report/page/lesson.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/report/page/excerpt.h"
#include "raylab/report/page/exercise_html.h"
#include "raylab/report/page/html.h"
#include "raylab/report/page/lesson_links.h"
#include "raylab/report/page/markdown.h"
#include "raylab/report/page/page_parts.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace raylab {

namespace fs = std::filesystem;

namespace {

using Kind = MarkdownBlock::Kind;

// The parts with which every lesson ends, by their anchors; what stands before them is its core.
const std::set<std::string> late_parts = {
    "speed-against-accuracy",      "where-it-fails",   "deeper", "try-this", "questions", "summary",
    "sources-and-further-reading", "words-and-symbols"};

// "chart: ray_sphere" names the chart ray_sphere.
std::optional<std::string> name_after(const std::string& word, const std::string& text) {
    if (!text.starts_with(word + ": ")) return std::nullopt;
    return text.substr(word.size() + 2);
}

// The number with which a name ends, as depth_3 does, and what stands before it.
std::string series_of(const std::string& name) {
    const auto last = name.find_last_not_of("0123456789");
    return last + 1 < name.size() && name[last] == '_' ? name.substr(0, last) : "";
}

class Composer {
public:
    Composer(const fs::path& readme, const LessonParts& parts, const fs::path& folder, ChapterRun::Place place)
        : readme_(readme), parts_(parts), folder_(folder), links_(readme, place) {}

    Lesson compose() {
        const auto text = read_file(readme_);
        for (const auto& block :
             markdown_blocks(text, [&](const std::string& target) { return links_.target(target); }))
            add(block);
        close_part();
        refuse_unused();
        anchor_words();
        lesson_.sources = links_.sources();
        return std::move(lesson_);
    }

private:
    void add(const MarkdownBlock& block) {
        line_ = block.line;
        if (block.kind == Kind::heading) return add_heading(block);
        if (block.kind == Kind::comment) return add_comment(block.text);
        if (const auto replaced = std::exchange(replaced_, std::nullopt)) {
            if (block.kind != Kind::table) refuse("a table below the comment that names it", "something else");
            return add_html(*replaced);
        }
        if (block.kind == Kind::images) return add_figures(block.images);
        if (block.kind == Kind::link) return add_html(linked(block));
        if (block.kind == Kind::list && part_ == "words-and-symbols") return add_words(block);
        if (block.html.starts_with("<p>Table: "))
            return add_html("<p class=\"caption\">" + block.html.substr(std::string("<p>Table: ").size()));
        add_html(block.kind == Kind::table ? "<div class=\"scroll wide\" tabindex=\"0\">" + block.html + "</div>\n"
                                           : block.html);
    }

    void add_heading(const MarkdownBlock& block) {
        if (block.level == 1) return;  // the page's own title
        const auto anchor = unique_anchor(block.text);
        if (block.level > 2) return add_html("<h3 id=\"" + anchor + "\">" + block.html + "</h3>\n");
        close_part();
        part_ = anchor;
        in_core_ = in_core_ && !late_parts.contains(anchor);
        lesson_.headings.push_back({block.html, anchor});
        lesson_.body += "<section id=\"" + anchor + "\" class=\"part " + (in_core_ ? "core" : anchor) + "\">\n<h2>" +
                        block.html + "</h2>\n";
    }

    void close_part() {
        if (replaced_) refuse("a table below the comment that names it", "the end of the part");
        if (!part_.empty()) lesson_.body += "</section>\n";
    }

    void add_html(const std::string& html) { (part_.empty() ? lesson_.introduction : lesson_.body) += html; }

    void add_comment(const std::string& text) {
        if (const auto table = name_after("table", text)) {
            replaced_ = made(parts_.tables, *table, "a table");
        } else if (const auto chart = name_after("chart", text)) {
            const auto found = parts_.charts.find(*chart);
            add_html(found != parts_.charts.end() ? found->second : not_run("./raylab chart " + *chart));
        } else if (text == "cases") {
            if (!parts_.cases.empty()) replaced_ = parts_.cases;
        } else if (const auto words = name_after("slide", text)) {
            add_html("<p hidden data-slide=\"" + escape_html(*words) + "\"></p>\n");
        } else {
            refuse("a comment that names a table, chart, slide or the cases", "'" + text + "'");
        }
    }

    // In place of a chart that was not asked for.
    static std::string not_run(const std::string& command) {
        return "<p class=\"not-run\">Not part of this run: <code>" + escape_html(command) + "</code></p>\n";
    }

    const std::string& made(const std::map<std::string, std::string>& all, const std::string& name,
                            const std::string& what) {
        used_.insert(name);
        const auto found = all.find(name);
        if (found == all.end()) refuse(what + " that the chapter's program makes", name);
        return found->second;
    }

    void add_figures(const std::vector<MarkdownImage>& images) {
        std::string html, series = series_of(fs::path(images.front().path).stem());
        for (const auto& image : images) {
            html += figure_html(image);
            if (series_of(fs::path(image.path).stem()) != series) series.clear();
        }
        if (images.size() > 1)
            html = "<div class=\"figures wide\"" +
                   (series.empty() ? "" : " data-series=\"" + escape_html(series) + "\"") + ">\n" + html + "</div>\n";
        add_html(html);
    }

    std::string figure_html(const MarkdownImage& image) {
        const auto name = fs::path(image.path).stem().string();
        const auto found = parts_.figures.find(name);
        if (found == parts_.figures.end()) refuse("a figure that the chapter's program makes", name);
        if (!used_.insert("figure " + name).second) refuse("each figure once", name + " twice");
        const auto& [file, floats, command, trees, walk] = found->second;
        const auto anchor = "fig-" + name;
        lesson_.figures.push_back({name, file, image.caption_text, anchor});
        const auto number = std::to_string(lesson_.figures.size());
        return "<figure id=\"" + escape_html(anchor) + "\"" + (is_drawing(file) ? " class=\"drawing\"" : "") +
               (trees.empty() ? "" : " data-trees=\"" + escape_html(trees) + "\"") + ">" +
               picture_html(folder_, file, image.caption_text) + "<figcaption><a class=\"step\" href=\"#" +
               escape_html(anchor) + "\">Figure " + number + "</a> " + image.caption +
               (floats.empty() ? "" : " <a class=\"floats\" href=\"" + escape_html(floats) + "\">as floats</a>") +
               (walk.empty() ? "" : " <a class=\"walk\" href=\"" + escape_html(walk) + "\">walk through it</a>") +
               "<span class=\"command\"><code>" + escape_html(command) + "</code></span></figcaption></figure>\n";
    }

    // A paragraph that is nothing but a link with a title: an exercise, or lines of a source.
    std::string linked(const MarkdownBlock& block) {
        const auto file = links_.file(block.target);
        if (block.title == "exercise") return exercise_html(file.parent_path(), block.html);
        const auto lines = excerpt(file, block.title);
        return "<figure class=\"excerpt\"><pre><code>" + escape_html(lines.text) +
               "</code></pre><figcaption><a href=\"" + escape_html(block.target) + "\">" + block.html + "</a>, lines " +
               std::to_string(lines.first_line) + " to " + std::to_string(lines.last_line) + "</figcaption></figure>\n";
    }

    void add_words(const MarkdownBlock& block) {
        std::string html = "<ul class=\"words\">\n";
        for (const auto& item : block.items) {
            if (item.term.empty()) refuse("a term in bold or a symbol before each meaning", item.html);
            const auto anchor = unique_anchor("word " + item.term);
            lesson_.words.push_back({item.term, item.html, anchor});
            html += "<li id=\"" + anchor + "\">" + item.html + "</li>\n";
        }
        add_html(html + "</ul>\n");
    }

    // A word's anchor is where the text defines it in bold.
    void anchor_words() {
        for (auto& word : lesson_.words) {
            const auto bold = "<strong>" + word.term + "</strong>";
            for (auto* html : {&lesson_.introduction, &lesson_.body}) {
                const auto at = html->find(bold);
                if (at == std::string::npos || html->rfind("<li id=\"" + word.anchor, at) != std::string::npos)
                    continue;
                const auto anchor = unique_anchor("term " + word.term);
                html->replace(at, std::string("<strong>").size(), "<strong class=\"term\" id=\"" + anchor + "\">");
                word.anchor = anchor;
                break;
            }
        }
    }

    std::string unique_anchor(const std::string& text) {
        const auto name = anchor_name(text);
        auto anchor = name;
        for (int again = 2; !anchors_.insert(anchor).second; ++again) anchor = name + "-" + std::to_string(again);
        return anchor;
    }

    void refuse_unused() {
        line_ = 1;
        for (const auto& [name, figure] : parts_.figures)
            if (!used_.contains("figure " + name))
                refuse("a place for each figure that the program makes", "none for " + name);
        for (const auto& [name, table] : parts_.tables)
            if (!used_.contains(name)) refuse("a place for each table that the program makes", "none for " + name);
    }

    [[noreturn]] void refuse(const std::string& expected, const std::string& found) const {
        throw Error({readme_.string(), line_}, expected, found);
    }

    fs::path readme_;
    const LessonParts& parts_;
    fs::path folder_;
    LessonLinks links_;
    Lesson lesson_;
    int line_ = 1;
    std::string part_;  // the anchor of the part that is open
    bool in_core_ = true;
    std::optional<std::string> replaced_;  // stands in place of the next table
    std::set<std::string> used_, anchors_;
};

}  // namespace

Lesson read_lesson(const fs::path& readme, const LessonParts& parts, const fs::path& folder, ChapterRun::Place place) {
    return Composer(readme, parts, folder, place).compose();
}

}  // namespace raylab
