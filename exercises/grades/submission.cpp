#include "submission.h"

#include "moment.h"
#include "sha256.h"
#include "source_text.h"

#include "raylab/base/file.h"
#include "raylab/base/printable.h"
#include "raylab/base/small_letters.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <string_view>
#include <system_error>

namespace raylab::grading {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_entries = 2000;  // of a folder; what is more is not looked at
constexpr int deepest_folder = 8;
constexpr std::size_t named_files = 4;

struct Files {
    std::vector<fs::path> all, links;  // regular files, and what is not followed; in order
    bool too_many = false;
};

Files files_in(const fs::path& folder) {
    Files files;
    std::error_code closed;
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, closed), end;
    for (std::size_t looked_at = 0; !closed && entry != end; entry.increment(closed)) {
        if (++looked_at > most_entries) return files.too_many = true, files;
        if (entry.depth() >= deepest_folder) entry.disable_recursion_pending();
        std::error_code gone;
        const auto kind = entry->symlink_status(gone);
        if (fs::is_regular_file(kind)) files.all.push_back(entry->path());
        if (fs::is_symlink(kind)) files.links.push_back(entry->path());
    }
    std::ranges::sort(files.all);
    std::ranges::sort(files.links);
    return files;
}

std::string names_of(const std::vector<fs::path>& files, const fs::path& folder) {
    std::string names;
    for (std::size_t i = 0; i < std::min(files.size(), named_files); ++i)
        names += (i ? ", " : "") + printable(files[i].lexically_relative(folder).string());
    return names + (files.size() > named_files ? fmt::format(" and {} more", files.size() - named_files) : "");
}

bool is_cpp(const fs::path& file) {
    constexpr std::array<std::string_view, 4> extensions{".cpp", ".cc", ".cxx", ".C"};
    return std::ranges::find(extensions, file.extension().string()) != extensions.end();
}

std::string time_of(const fs::path& file) {
    std::error_code missing;
    const auto time = std::chrono::file_clock::to_sys(fs::last_write_time(file, missing));
    return missing ? "" : to_string(std::chrono::floor<std::chrono::seconds>(time));
}

// Not the file of another exercise, which lies in the same folder of a student.
bool is_anothers(const Exercise& asked, const fs::path& file) {
    return std::ranges::any_of(exercises(), [&](const Exercise& other) {
        return other.slot != asked.slot && file.filename() == other.slot + ".cpp";
    });
}

std::string words_of_missing(const std::string& wanted, const Files& files, const fs::path& folder) {
    auto words = fmt::format("expected a file {}, found {}", wanted,
                             files.all.empty() ? "no file" : names_of(files.all, folder));
    const auto is_nearly = [&](const fs::path& file) { return equal_ignoring_case(file.filename().string(), wanted); };
    if (std::ranges::any_of(files.all, is_nearly)) words += "; small letters and capitals differ";
    if (!files.links.empty()) words += "; not followed, since it is a link: " + names_of(files.links, folder);
    return words;
}

Submission in_folder(const Exercise& exercise, const fs::path& folder) {
    const auto wanted = exercise.slot + ".cpp";
    const auto files = files_in(folder);
    if (files.too_many)
        return {{}, {}, fmt::format("the folder has more than {} entries: hand in {} alone", most_entries, wanted)};
    std::vector<fs::path> named, others;
    for (const auto& file : files.all) (file.filename() == wanted ? named : others).push_back(file);
    if (named.size() > 1)
        return {{}, {}, fmt::format("there are {} files {}: {}", named.size(), wanted, names_of(named, folder))};
    const auto may_be_meant = [&](const fs::path& file) { return is_cpp(file) && !is_anothers(exercise, file); };
    if (named.empty() && std::ranges::count_if(others, may_be_meant) == 1) {
        named.push_back(*std::ranges::find_if(others, may_be_meant));
        std::erase(others, named.front());
    }
    if (named.empty()) return {{}, {}, words_of_missing(wanted, files, folder)};
    Submission found{named.front(), {}, {}};
    if (named.front().filename() != wanted)
        found.submitted.notes.push_back("taken for " + wanted + ", since it is the only C++ file");
    if (!others.empty()) found.submitted.notes.push_back("ignored: " + names_of(others, folder));
    return found;
}

// By the bytes that a file of the kind begins with, or has at a place (tar).
std::string kind_of_archive(std::string_view text) {
    const auto has = [&](std::size_t at, std::string_view bytes) {
        return text.size() >= at + bytes.size() && text.substr(at, bytes.size()) == bytes;
    };
    if (has(0, "PK\x03\x04") || has(0, "PK\x05\x06")) return "a ZIP archive";
    if (has(0, "\x1f\x8b") || has(0, "BZh") ||
        has(0, "\xfd"
               "7zXZ"))
        return "a compressed file";
    if (has(257, "ustar")) return "a tar archive";
    if (has(0, "7z\xbc\xaf") || has(0, "Rar!")) return "an archive";
    return {};
}

std::string fault_of(std::string_view text, const std::string& wanted) {
    if (text.find_first_not_of(" \t\r\n\f\v") == text.npos) return "the file is empty";
    if (const auto archive = kind_of_archive(text); !archive.empty())
        return fmt::format("the file is {}, which is not unpacked: hand in {} itself", archive, wanted);
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) return "the file is UTF-16: save it as UTF-8";
    if (text.find('\0') != text.npos) return "the file is no text, but binary data: hand in the source";
    return {};
}

}  // namespace

std::string fault_of_link(const fs::path& handed_in) {
    // "folder/" leads to where a link of that name does, and "folder" is the link.
    const auto named = handed_in.has_filename() ? handed_in : handed_in.parent_path();
    std::error_code missing;
    if (!fs::is_symlink(fs::symlink_status(named, missing))) return {};
    // Without its name, which is the student's in a class and must not be told where there are pseudonyms.
    return "what was handed in is a symbolic link, which is not followed: hand in what it leads to";
}

Submission find_submission(const Exercise& exercise, const fs::path& file_or_folder) {
    std::error_code missing;
    if (const auto link = fault_of_link(file_or_folder); !link.empty()) return {{}, {}, link};
    const auto kind = fs::status(file_or_folder, missing);
    if (!fs::exists(kind)) return {{}, {}, "there is no file " + printable(file_or_folder.filename().string())};
    const bool in_a_folder = fs::is_directory(kind);
    auto found = in_a_folder ? in_folder(exercise, file_or_folder) : Submission{file_or_folder, {}, {}};
    if (!found.fault.empty()) return found;
    auto& [file, submitted, fault] = found;
    submitted.file = in_a_folder ? printable(file.filename().string()) : exercise.slot + ".cpp";
    submitted.modified = time_of(file);
    if (!fs::is_regular_file(file, missing)) return fault = submitted.file + " is no regular file", found;
    submitted.bytes = fs::file_size(file, missing);
    if (submitted.bytes > largest_source) {
        fault = fmt::format("the file has {:.1f} MB, and an answer may have {}",
                            static_cast<double>(submitted.bytes) / (1 << 20), largest_source >> 20);
        return found;
    }
    const auto text = read_file(file, largest_source);
    submitted.sha256 = hexadecimal(sha256(text));
    fault = fault_of(text, exercise.slot + ".cpp");
    return found;
}

}  // namespace raylab::grading
