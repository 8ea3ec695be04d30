#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

// A lesson's Markdown, in GitHub's dialect, as blocks of HTML. cmark-gfm reads it.

namespace raylab {

struct MarkdownImage {
    std::string path;
    std::string caption;       // as HTML
    std::string caption_text;  // as plain text
};

/// An item of a list.
struct MarkdownItem {
    std::string term;  // as HTML: what is bold at its beginning, or the symbols before its colon; empty: neither
    std::string html;  // the whole item, without <li>
};

/// One block of the document, and what a page needs to know of it.
struct MarkdownBlock {
    enum class Kind {
        heading,
        paragraph,
        images,   // a paragraph of nothing but images
        link,     // a paragraph of nothing but one link with a title
        comment,  // <!-- text -->
        list,
        table,
        other
    } kind = Kind::other;
    int line = 0;                            // in the file, from 1
    std::string html = {};                   // of a heading and a link: what is inside
    std::string text = {};                   // of a heading: its words; of a comment: what it says
    int level = 0;                           // of a heading
    std::string target = {}, title = {};     // of a link
    std::vector<MarkdownImage> images = {};  // of images
    std::vector<MarkdownItem> items = {};    // of a list
};

/// The blocks of a document that is trusted: HTML passes through. `link` gives the target that a link gets in the
/// page; where it is empty the link's words stay, without a link.
std::vector<MarkdownBlock> markdown_blocks(std::string_view markdown,
                                           const std::function<std::string(const std::string&)>& link);

}  // namespace raylab
