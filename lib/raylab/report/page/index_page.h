#pragma once

#include "raylab/report/page/book.h"

#include <filesystem>
#include <string>
#include <vector>

// The book's index: words and symbols with their meanings, methods, failure cases; and the same for the search.

namespace raylab {

/// Something that can be looked up.
struct IndexEntry {
    enum class Kind { chapter, part, figure, chart, failure_case, method, word } kind;
    std::string html;     // its name: a word may be a formula
    std::string meaning;  // of a word, as HTML; empty otherwise
    std::string address;  // relative to the book's folder: "07_recursion/index.html#the-ray-tree"
    std::string chapter;  // "07"
};

/// Everything that the chapters' pages say about themselves (page.json), in the chapters' order.
std::vector<IndexEntry> index_entries(const std::filesystem::path& folder, const std::vector<BookEntry>& chapters);

/// The page glossary.html.
std::string index_html(const std::vector<IndexEntry>& entries);

/// The script search.js: raylab_search([[kind, words, address, chapter], ...]).
std::string search_script(const std::vector<IndexEntry>& entries);

}  // namespace raylab
