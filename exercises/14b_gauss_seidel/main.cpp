#include "answering.h"
#include "arguments.h"

// The student's program: cases in, answers out. `raylab check 14b` starts it and judges its answers.
int main() {
    using namespace raylab::grading;
    return answer_cases(gauss_seidel::inputs, gauss_seidel::outputs, [](auto input, auto output) {
        gauss_seidel::answer(&raylab::gauss_seidel_sweep, input, output);
    });
}
