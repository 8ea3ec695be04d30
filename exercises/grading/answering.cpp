#include "answering.h"

#include "raylab/base/unfinished.h"

#include <unistd.h>

#include <cstdio>
#include <exception>
#include <limits>
#include <new>
#include <vector>

namespace raylab::grading {

namespace {

constexpr std::size_t flushed_cases = 4096;  // more than any exercise asks

// Calls say_all(answers) and returns the exit code that tells how it ended.
int said(const std::function<void(std::FILE* answers)>& say_all) {
    std::FILE* answers = fdopen(dup(STDOUT_FILENO), "wb");
    if (!answers || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) return exit_thrown;
    try {
        say_all(answers);
    } catch (const Unfinished& unfinished) {
        std::fprintf(stderr, "%s\n", unfinished.what());
        std::fclose(answers);
        return exit_unfinished;
    } catch (const std::bad_alloc&) {
        std::fclose(answers);
        return exit_out_of_memory;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s%s\n", thrown_words, error.what());
        std::fclose(answers);
        return exit_thrown;
    } catch (...) {
        std::fprintf(stderr, "%sone that is no std::exception\n", thrown_words);
        std::fclose(answers);
        return exit_thrown;
    }
    return std::fclose(answers) == 0 ? 0 : exit_thrown;
}

}  // namespace

int answer_cases(std::size_t inputs, std::size_t outputs, const Answer& answer) {
    return said([&](std::FILE* answers) {
        std::vector<double> input(inputs), output(outputs);
        std::size_t answered = 0;
        while (std::fread(input.data(), sizeof(double), inputs, stdin) == inputs) {
            // Values that the function does not set are NaN, so that no value of the last case can count as right.
            output.assign(outputs, std::numeric_limits<double>::quiet_NaN());
            answer(input, output);
            std::fwrite(output.data(), sizeof(double), outputs, answers);
            // What was answered before a crash has to be outside. A picture's pixels need not.
            if (++answered <= flushed_cases) std::fflush(answers);
        }
    });
}

int answer_work(const std::vector<WorkTask>& tasks, std::size_t outputs, const Answer& answer) {
    return said([&](std::FILE* answers) {
        for (const WorkTask& task : tasks) {
            double largest = 0;
            if (std::fread(&largest, sizeof largest, 1, stdin) != 1) return;
            traced(task, static_cast<std::size_t>(largest),
                   [&](std::span<const double> input, std::span<double> output) {
                       answer(input, output);
                       std::fwrite(output.data(), sizeof(double), outputs, answers);
                   });
        }
    });
}

}  // namespace raylab::grading
