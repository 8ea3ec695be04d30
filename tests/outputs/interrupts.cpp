#include "catch.h"
#include "outputs/workplace.h"

#include "raylab/base/child.h"
#include "raylab/base/descriptor.h"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <thread>

// Tests of commands that are ended by a signal while they work.

using namespace raylab;
namespace fs = std::filesystem;

namespace {

/// `raylab` with these words, at work in the folder, where its temporary folders are, too; it runs in the background.
class Working {
public:
    Working(const fs::path& folder, std::vector<std::string> words) : pipe_(make_pipe()) {
        fs::create_directory(folder / "tmp");
        words.insert(words.begin(), {"env", "TMPDIR=" + (folder / "tmp").string(), RAYLAB_BUILD "/raylab"});
        Launch launch{.words = {},
                      .folder = folder.c_str(),
                      .input = pipe_.read.number(),
                      .output = pipe_.write.number(),
                      .errors = pipe_.write.number(),
                      .failure = pipe_.write.number(),
                      .parent = getpid()};
        for (auto& word : words) launch.words.push_back(word.data());
        launch.words.push_back(nullptr);
        child_.emplace(launch);
    }

    /// The status of waitpid() after the signal.
    int ended_by(int signal) {
        kill(child_->id(), signal);
        return child_->end();
    }

    /// The last that it said, up to a few thousand characters.
    std::string said() const {
        std::string text(4096, ' ');
        const auto size = read(pipe_.read.number(), text.data(), text.size());
        text.resize(size < 0 ? 0 : static_cast<std::size_t>(size));
        return text;
    }

private:
    Pipe pipe_;
    std::optional<Child> child_;
};

/// Waits until a temporary folder in `folder` is no longer empty.
void wait_for_temporaries_in(const fs::path& folder) {
    const auto found = [&] {
        for (const auto& entry : fs::directory_iterator(folder)) {
            std::error_code gone;
            if (entry.path().filename().string().starts_with(".raylab-") && !fs::is_empty(entry.path(), gone) && !gone)
                return true;
        }
        return false;
    };
    for (int tries = 0; tries < 3000 && !found(); ++tries) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    REQUIRE(found());
}

const std::vector<std::string> chapter = {"chapter", "02", "--out", "."};
const std::vector<std::string> chart = {"chart", "ray_sphere", "-o", "."};

}  // namespace

TEST_CASE("a command that is interrupted leaves its folder and TMPDIR as they were, and exits with 128 + the signal") {
    const Workplace workplace;
    fs::create_directory(workplace.path() / "tmp");
    const auto before = workplace.contents();
    for (const int signal : {SIGINT, SIGTERM})
        for (const auto& [words, temporaries] : {std::pair{chapter, "."}, std::pair{chart, "tmp"}}) {
            Working command(workplace.path(), words);
            wait_for_temporaries_in(workplace.path() / temporaries);
            const int status = command.ended_by(signal);
            INFO(words_of(words) << " ended with " << status);
            CHECK(WIFEXITED(status));
            CHECK(WEXITSTATUS(status) == 128 + signal);
            CHECK(workplace.contents() == before);
        }
}

TEST_CASE("what a killed command leaves behind is removed by the next one") {
    const Workplace workplace;
    fs::create_directory(workplace.path() / "tmp");
    const auto before = workplace.contents();
    Working command(workplace.path(), chapter);
    wait_for_temporaries_in(workplace.path());
    CHECK(WIFSIGNALED(command.ended_by(SIGKILL)));
    CHECK(workplace.contents() != before);
    CHECK(workplace.lab({"needs", "scene.toml", "--json", "needs.json"}).succeeded());
    fs::remove(workplace.path() / "needs.json");
    CHECK(workplace.contents() == before);
}

TEST_CASE("radiosity that is interrupted says what it keeps") {
    const Workplace workplace;
    Working command(workplace.path(), {"radiosity", RAYLAB_SOURCE "/chapters/14_radiosity/scene.toml", "--edge", "0.01",
                                       "--cache", "kept"});
    for (int tries = 0; tries < 3000 && !fs::exists(workplace.path() / "kept"); ++tries)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    const int status = command.ended_by(SIGINT);
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 128 + SIGINT);
    CHECK_THAT(command.said(), Catch::Contains("stopped; what was complete is kept in kept"));
}
