#include "raylab/report/page/html.h"

#include "raylab/report/page/cmark.h"
#include "raylab/report/page/formula.h"

#include <cctype>

namespace raylab {

namespace {

// Only links to a page beside this one, to a place in it, or to the web are safe; any other, such as javascript:, is
// shown as plain text.
bool is_safe_link(std::string_view link) {
    if (link.starts_with("https://") || link.starts_with("http://")) return true;
    return !link.empty() && link.find(':') == std::string_view::npos && !link.starts_with("//");
}

void replace_by_text(cmark_node* node) {
    auto* text = cmark_node_new(CMARK_NODE_TEXT);
    cmark_node_set_literal(text, cmark_node_get_literal(node));
    auto* replaced = text;
    if (cmark_node_get_type(node) == CMARK_NODE_HTML_BLOCK) {
        replaced = cmark_node_new(CMARK_NODE_PARAGRAPH);
        cmark_node_append_child(replaced, text);
    }
    cmark_node_replace(node, replaced);
    cmark_node_free(node);
}

// Text of any origin: HTML in it is shown, not obeyed.
MarkdownDocument harmless(std::string_view markdown) {
    MarkdownDocument document(markdown, CMARK_OPT_NOBREAKS);
    document.for_each([](cmark_node* node) {
        const auto type = cmark_node_get_type(node);
        if (type == CMARK_NODE_LINK && !is_safe_link(cmark_node_get_url(node)))
            replace_by_children(node);
        else if (type == CMARK_NODE_HTML_INLINE || type == CMARK_NODE_HTML_BLOCK)
            replace_by_text(node);
    });
    return document;
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
    const auto document = harmless(markdown);
    return document.html(document.root());
}

std::string html_from_markdown_line(std::string_view markdown) {
    // Behind a character that no text has, a hyphen begins no list and a number sign no heading.
    constexpr std::string_view front = "\uE002";
    InlineFormulas formulas;
    const auto document = harmless(std::string(front) + formulas.take_from(markdown));
    std::string html;
    for (auto* block = cmark_node_first_child(document.root()); block; block = cmark_node_next(block))
        for (auto* part = cmark_node_first_child(block); part; part = cmark_node_next(part))
            html += document.html(part);
    return formulas.put_into(html.substr(html.find(front) + front.size()));
}

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
