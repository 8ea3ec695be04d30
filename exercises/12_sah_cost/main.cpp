#include "answering.h"
#include "walk.h"

// The student's program: cases in, answers out. `raylab check 12` starts it and judges its answers; with an argument,
// it does the counted work.
int main(int words, char**) {
    using namespace raylab::grading;
    const auto answer = [](auto input, auto output) { cuts::answer(&raylab::sah_cost, input, output); };
    if (words > 1) return answer_work(cuts::work_tasks(), cuts::outputs, answer);
    return answer_cases(cuts::inputs, cuts::outputs, answer);
}
