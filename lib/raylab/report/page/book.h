#pragma once

#include "raylab/report/provenance.h"

#include <filesystem>
#include <string>
#include <vector>

// The lab book: the front page of all chapters' pages.

namespace raylab {

/// A chapter as the front page shows it.
struct BookEntry {
    std::string folder, title, question;
    std::string picture = {}, picture_shows = {};  // beside the chapter's page; empty: none
    std::vector<std::string> charts = {};
    std::size_t cases = 0, cases_as_expected = 0;
    double seconds = 0;
    std::string problem = {};  // why there is no page; empty: there is one
};

/// What a chapter's page.json says.
BookEntry read_entry(const std::filesystem::path& chapter_folder);

/// For a chapter that did not run: a page that says so, so that no link leads nowhere.
void write_problem_page(const std::filesystem::path& chapter_folder, const BookEntry& entry);

/// The front page, to stand in the folder that the chapters' folders are in.
std::string book_html(const std::filesystem::path& folder, const std::vector<BookEntry>& entries,
                      const std::vector<Fact>& facts);

/// folder/index.html.
void write_book(const std::filesystem::path& folder, const std::vector<BookEntry>& entries,
                const std::vector<Fact>& facts);

}  // namespace raylab
