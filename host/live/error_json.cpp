#include "live/error_json.h"

#include <filesystem>
#include <fstream>
#include <regex>

namespace hyalite::live {

namespace {

constexpr int kLinesAbout = 3; // before and after the one in question

Json excerpt(const SourceLocation& where) {
    Json lines = Json::array();
    std::error_code ignored;
    if (where.line <= 0 || !std::filesystem::is_regular_file(where.file, ignored)) {
        return lines;
    }
    std::ifstream stream(where.file);
    std::string text;
    for (int line = 1; line <= where.line + kLinesAbout && std::getline(stream, text); ++line) {
        if (line >= where.line - kLinesAbout) {
            lines.push_back({{"line", line}, {"text", text.substr(0, 400)}});
        }
    }
    return lines;
}

} // namespace

Json describe(const Error& error, const std::string& source) {
    const SourceLocation& where = error.where();
    Json json{{"source", source},   {"message", error.message()}, {"hint", error.hint()}, {"file", where.file},
              {"line", where.line}, {"column", where.column},     {"kernel", ""},         {"excerpt", excerpt(where)}};
    std::smatch kernel;
    const std::string& message = error.message();
    if (std::regex_search(message, kernel, std::regex("kernel '([a-z0-9_]+)'"))) {
        json["kernel"] = kernel[1].str();
    }
    return json;
}

} // namespace hyalite::live
