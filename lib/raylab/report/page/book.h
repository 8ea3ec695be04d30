#pragma once

#include "raylab/report/provenance.h"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

// The lab book: the front page of all chapters' pages.

namespace raylab {

/// A chapter's entry on the front page.
struct BookEntry {
    std::string folder, title, question;
    std::string picture = {}, picture_shows = {};  // beside the chapter's page; empty: none
    std::vector<std::string> charts = {};
    std::size_t cases = 0, cases_as_expected = 0;
    double seconds = 0;
    std::string problem = {};  // the reason why there is no page; empty where there is one
};

/// Reads a chapter's page.json.
BookEntry read_entry(const std::filesystem::path& chapter_folder);

/// Writes a page for a chapter that did not run, so that no link is broken.
void write_problem_page(const std::filesystem::path& chapter_folder, const BookEntry& entry);

/// The files beside the chapters' folders: the front page, the index of words, methods and cases, what the search
/// reads.
inline constexpr std::array book_file_names{"index.html", "glossary.html", "search.js"};
struct BookFile {
    std::string name, text;
};

/// The picture of the front page, which `tour` draws beside those files: 1600 by 700 pixels, or half of that.
inline constexpr const char* book_cover = "cover.png";

/// The page of the exercises' typical mistakes, which the front page links to and `tour` writes beside it, too.
inline constexpr const char* book_mistakes = "mistakes.html";

/// Makes those files for the folder that contains the chapters' folders.
std::vector<BookFile> book_files(const std::filesystem::path& folder, const std::vector<BookEntry>& entries,
                                 const std::vector<Fact>& facts);

}  // namespace raylab
