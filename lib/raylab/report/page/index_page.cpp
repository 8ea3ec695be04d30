#include "raylab/report/page/index_page.h"

#include "raylab/base/read_json.h"
#include "raylab/base/small_letters.h"
#include "raylab/report/page/html.h"
#include "raylab/report/page/page_parts.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <set>

namespace raylab {

namespace fs = std::filesystem;

namespace {

using EntryKind = IndexEntry::Kind;

// HTML without its elements, as a reader sees it.
std::string without_tags(const std::string& html) {
    static const std::map<std::string, std::string> letters{
        {"&amp;", "&"}, {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"}};
    std::string text;
    for (std::size_t at = 0; at < html.size(); ++at) {
        const auto end = html.find(html[at] == '<' ? '>' : ';', at);
        if (html[at] == '<' && end != std::string::npos) {
            at = end;
        } else if (const auto letter = letters.find(html.substr(at, end - at + 1));
                   html[at] == '&' && letter != letters.end()) {
            text += letter->second;
            at = end;
        } else {
            text += html[at];
        }
    }
    return text;
}

// The entries of one chapter; those of `all` are added to.
class ChapterIndex {
public:
    ChapterIndex(const BookEntry& chapter, std::vector<IndexEntry>& all)
        : page_(chapter.folder + "/index.html"), chapter_(chapter.folder.substr(0, 2)), all_(all) {}

    void add(EntryKind kind, const std::string& html, const std::string& anchor, const std::string& meaning = {}) {
        all_.push_back({kind, html, meaning, page_ + (anchor.empty() ? "" : "#" + anchor), chapter_});
    }

private:
    std::string page_, chapter_;
    std::vector<IndexEntry>& all_;
};

void add_page(const nlohmann::ordered_json& page, ChapterIndex& index) {
    const auto each = [&](const char* list, const auto& use) {
        if (page.contains(list))
            for (const auto& item : page[list]) use(item);
    };
    each("headings", [&](const auto& heading) { index.add(EntryKind::part, heading["words"], heading["anchor"]); });
    each("words", [&](const auto& word) { index.add(EntryKind::word, word["term"], word["anchor"], word["html"]); });
    each("figures", [&](const auto& figure) {
        index.add(EntryKind::figure, escape_html(figure["caption"].template get<std::string>()), figure["anchor"]);
    });
    each("methods", [&](const auto& method) {
        index.add(EntryKind::method, escape_html(method["name"].template get<std::string>()), method["anchor"]);
    });
    each("charts",
         [&](const std::string& chart) { index.add(EntryKind::chart, escape_html(chart), "chart-" + chart); });
    each("case_names",
         [&](const std::string& name) { index.add(EntryKind::failure_case, escape_html(name), anchor_name(name)); });
}

std::string to_string(EntryKind kind) {
    switch (kind) {
        case EntryKind::chapter:
            return "chapter";
        case EntryKind::part:
            return "part";
        case EntryKind::figure:
            return "figure";
        case EntryKind::chart:
            return "chart";
        case EntryKind::failure_case:
            return "case";
        case EntryKind::method:
            return "method";
        case EntryKind::word:
            return "word";
    }
    return "";
}

// Those of a kind, by the alphabet.
std::vector<IndexEntry> sorted(const std::vector<IndexEntry>& entries, EntryKind kind) {
    std::vector<IndexEntry> some;
    std::ranges::copy_if(entries, std::back_inserter(some), [&](const auto& entry) { return entry.kind == kind; });
    std::ranges::stable_sort(some, {}, [](const auto& entry) { return in_small_letters(without_tags(entry.html)); });
    return some;
}

bool is_symbol(const IndexEntry& word) { return word.html.find("<math") != std::string::npos; }

std::string chapter_link(const IndexEntry& entry) {
    return "<a href=\"" + escape_html(entry.address) + "\">chapter " + escape_html(entry.chapter) + "</a>";
}

// A word with its meaning and the place where it is defined; a symbol may mean something else in another chapter.
std::string words_html(const std::vector<IndexEntry>& words) {
    std::string html = "<ul class=\"words\">\n";
    std::set<std::string> anchors;
    for (const auto& word : words) {
        auto anchor = anchor_name(without_tags(word.html));
        if (!anchors.insert(anchor).second) anchor += "-" + word.chapter;
        html += std::string("<li id=\"") + (is_symbol(word) ? "symbol-" : "word-") + anchor + "\">" + word.meaning +
                " (" + chapter_link(word) + ")</li>\n";
    }
    return html + "</ul>\n";
}

// A name with all its places.
std::string names_html(const std::vector<IndexEntry>& entries) {
    std::string html = "<ul class=\"names\">\n", last;
    for (const auto& entry : entries) {
        if (entry.html != last) html += std::string(last.empty() ? "" : "</li>\n") + "<li>" + entry.html + ": ";
        html += (entry.html == last ? ", " : "") + chapter_link(entry);
        last = entry.html;
    }
    return html + (last.empty() ? "" : "</li>\n") + "</ul>\n";
}

std::string part_html(const std::string& anchor, const std::string& heading, const std::string& list) {
    return "<section id=\"" + anchor + "\"><h2>" + heading + "</h2>\n" + list + "</section>\n";
}

}  // namespace

std::vector<IndexEntry> index_entries(const fs::path& folder, const std::vector<BookEntry>& chapters) {
    std::vector<IndexEntry> entries;
    for (const auto& chapter : chapters) {
        ChapterIndex index(chapter, entries);
        index.add(EntryKind::chapter, escape_html(chapter.title + ": " + chapter.question), "");
        if (chapter.problem.empty()) add_page(read_json(folder / chapter.folder / "page.json"), index);
    }
    return entries;
}

std::string index_html(const std::vector<IndexEntry>& entries) {
    auto words = sorted(entries, EntryKind::word);
    const auto symbols = std::ranges::stable_partition(words, [](const auto& word) { return !is_symbol(word); });
    const std::string body =
        "<header>\n<p class=\"number\">raylab</p>\n<h1>Index</h1>\n<p class=\"question\">Words and symbols where they are "
        "defined, methods where they are compared, and the cases in which they fail.</p>\n<ul class=\"contents\"><li><a "
        "href=\"#words\">Words</a></li><li><a href=\"#symbols\">Symbols</a></li><li><a href=\"#methods\">Methods</a></li>"
        "<li><a href=\"#cases\">Cases</a></li></ul></header>\n<main id=\"content\">\n" +
        part_html("words", "Words", words_html({words.begin(), symbols.begin()})) +
        part_html("symbols", "Symbols", words_html({symbols.begin(), symbols.end()})) +
        part_html("methods", "Methods", names_html(sorted(entries, EntryKind::method))) +
        part_html("cases", "Cases in which methods fail", names_html(sorted(entries, EntryKind::failure_case))) +
        "</main>\n";
    return whole_page({.title = "Index · raylab lab book", .kind = "index"}, way_to_front_page("index.html"), body);
}

std::string search_script(const std::vector<IndexEntry>& entries) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const auto& entry : entries)
        all.push_back({to_string(entry.kind), without_tags(entry.meaning.empty() ? entry.html : entry.meaning),
                       entry.address, "chapter " + entry.chapter});
    return "raylab_search(" + all.dump() + ");\n";
}

}  // namespace raylab
