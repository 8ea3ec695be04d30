#include "raylab/report/diagram/diagram_text.h"

namespace raylab {

std::string diagram_text(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '\\')
            escaped += "\\\\";
        else if (c == '&')
            escaped += "&amp;";
        else if (c == '\n')
            escaped += "\\n";
        else if (code < 0x20 || code == 0x7f)
            escaped += ' ';
        else
            escaped += c;
    }
    return escaped;
}

std::string without_date(std::string pdf) {
    constexpr std::string_view key = "Date (D:", some_day = "20000101000000";
    for (auto at = pdf.find(key); at != std::string::npos; at = pdf.find(key, at + 1))
        if (at + key.size() + some_day.size() <= pdf.size()) pdf.replace(at + key.size(), some_day.size(), some_day);
    return pdf;
}

}  // namespace raylab
