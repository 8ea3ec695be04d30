#include "raylab/report/page/html.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <vector>

namespace raylab {

namespace {

// Only links to a page beside this one, to a place in it, or to the web are safe; any other, such as javascript:, is
// shown as plain text.
bool is_safe_link(std::string_view link) {
    if (link.starts_with("https://") || link.starts_with("http://")) return true;
    return !link.empty() && link.find(':') == std::string_view::npos && !link.starts_with("//");
}

/// The text between two marks, and where it ends.
struct Span {
    std::string_view inside;
    std::size_t end;  // just after the closing mark
};

std::optional<Span> between(std::string_view text, std::size_t at, std::string_view open, std::string_view close) {
    if (!text.substr(at).starts_with(open)) return std::nullopt;
    const auto begin = at + open.size();
    const auto end = text.find(close, begin);
    if (end == std::string_view::npos || end == begin) return std::nullopt;
    return Span{text.substr(begin, end - begin), end + close.size()};
}

// An asterisk between blanks, as in "a * b", is a character and not a mark.
std::optional<Span> emphasis(std::string_view text, std::size_t at, std::string_view mark) {
    const auto span = between(text, at, mark, mark);
    if (!span || std::isspace(static_cast<unsigned char>(span->inside.front())) ||
        std::isspace(static_cast<unsigned char>(span->inside.back())))
        return std::nullopt;
    return span;
}

std::string inline_html(std::string_view text) {
    std::string html;
    for (std::size_t at = 0; at < text.size();) {
        if (const auto code = between(text, at, "`", "`")) {
            html += "<code>" + escape_html(code->inside) + "</code>";
            at = code->end;
        } else if (const auto strong = emphasis(text, at, "**")) {
            html += "<strong>" + inline_html(strong->inside) + "</strong>";
            at = strong->end;
        } else if (const auto em = emphasis(text, at, "*")) {
            html += "<em>" + inline_html(em->inside) + "</em>";
            at = em->end;
        } else if (const auto name = between(text, at, "[", "]")) {
            const auto link = between(text, name->end, "(", ")");
            if (link && is_safe_link(link->inside)) {
                html += "<a href=\"" + escape_html(link->inside) + "\">" + inline_html(name->inside) + "</a>";
                at = link->end;
            } else {
                html += text[at++];
            }
        } else {
            html += escape_html(text.substr(at++, 1));
        }
    }
    return html;
}

enum class Kind { paragraph, bullets, numbers, code };

/// Consecutive lines of one kind.
struct Block {
    Kind kind;
    std::vector<std::string> items;  // one item for paragraphs and code
};

std::optional<std::string_view> after_number(std::string_view line) {
    const auto digits = line.find_first_not_of("0123456789");
    if (digits == 0 || digits == std::string_view::npos || !line.substr(digits).starts_with(". ")) return std::nullopt;
    return line.substr(digits + 2);
}

void add_item(std::vector<Block>& blocks, Kind kind, std::string_view item) {
    if (blocks.empty() || blocks.back().kind != kind) blocks.push_back({kind, {}});
    blocks.back().items.emplace_back(item);
}

std::vector<Block> blocks_of(std::string_view markdown) {
    std::vector<Block> blocks;
    bool in_code = false;
    bool fresh = true;  // whether the line before was empty
    for (std::size_t at = 0; at <= markdown.size();) {
        const auto end = std::min(markdown.find('\n', at), markdown.size());
        auto line = markdown.substr(at, end - at);
        at = end + 1;
        if (line.ends_with('\r')) line.remove_suffix(1);
        const auto text = line.substr(std::min(line.find_first_not_of(' '), line.size()));
        if (text.starts_with("```")) {
            in_code = !in_code;
            if (in_code) blocks.push_back({Kind::code, {""}});
            fresh = true;
        } else if (in_code) {
            blocks.back().items.back() += std::string(line) + "\n";
        } else if (text.empty()) {
            fresh = true;
        } else if (text.starts_with("- ")) {
            add_item(blocks, Kind::bullets, text.substr(2));
            fresh = false;
        } else if (const auto numbered = after_number(text)) {
            add_item(blocks, Kind::numbers, *numbered);
            fresh = false;
        } else if (fresh) {
            blocks.push_back({Kind::paragraph, {std::string(text)}});
            fresh = false;
        } else {
            blocks.back().items.back() += " " + std::string(text);
        }
    }
    return blocks;
}

std::string html_of(const Block& block) {
    if (block.kind == Kind::paragraph) return "<p>" + inline_html(block.items[0]) + "</p>\n";
    if (block.kind == Kind::code) return "<pre><code>" + escape_html(block.items[0]) + "</code></pre>\n";
    const std::string tag = block.kind == Kind::bullets ? "ul" : "ol";
    std::string html = "<" + tag + ">\n";
    for (const auto& item : block.items) html += "<li>" + inline_html(item) + "</li>\n";
    return html + "</" + tag + ">\n";
}

}  // namespace

std::string escape_html(std::string_view text) {
    std::string html;
    for (const char c : text) {
        switch (c) {
            case '&':
                html += "&amp;";
                break;
            case '<':
                html += "&lt;";
                break;
            case '>':
                html += "&gt;";
                break;
            case '"':
                html += "&quot;";
                break;
            case '\'':
                html += "&#39;";
                break;
            default:
                html += c;
        }
    }
    return html;
}

std::string html_from_markdown(std::string_view markdown) {
    std::string html;
    for (const auto& block : blocks_of(markdown)) html += html_of(block);
    return html;
}

std::string html_from_markdown_line(std::string_view markdown) { return inline_html(markdown); }

std::string anchor_name(std::string_view text) {
    std::string name;
    for (const char c : text) {
        if (std::isalnum(static_cast<unsigned char>(c)))
            name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (!name.empty() && name.back() != '-')
            name += '-';
    }
    while (name.ends_with('-')) name.pop_back();
    return name.empty() ? "part" : name;
}

}  // namespace raylab
