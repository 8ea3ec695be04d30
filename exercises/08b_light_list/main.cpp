#include "answering.h"
#include "arguments.h"

// The student's program: cases in, answers out. `raylab check 08b` starts it and judges its answers.
int main() {
    using namespace raylab::grading;
    return answer_cases(light_list::inputs, light_list::outputs, [](auto input, auto output) {
        light_list::answer(&raylab::light_through_list, input, output);
    });
}
