#pragma once

#include <filesystem>
#include <string>

namespace raylab {

/// A chapter's page (page.h) as a deck, in one HTML file that needs no other file and no network: its pictures are in
/// it, it opens as a lecture, and what linked to other files of the lab book is plain words. Throws an Error for a
/// picture that is not beside the page.
std::string deck_from_page(const std::filesystem::path& page);

}  // namespace raylab
