#include "live/messages/error_report.h"

#include <filesystem>
#include <fstream>
#include <regex>

namespace hyalite::live {

namespace {

constexpr int kLinesAround = 3; // before and after the line of the error
constexpr std::size_t kLongestLine = 400;

std::vector<SourceLine> excerptOf(const SourceLocation& where) {
    std::vector<SourceLine> lines;
    std::error_code ignored;
    if (where.line <= 0 || !std::filesystem::is_regular_file(where.file, ignored)) {
        return lines;
    }
    std::ifstream stream(where.file);
    std::string text;
    for (int line = 1; line <= where.line + kLinesAround && std::getline(stream, text); ++line) {
        if (line >= where.line - kLinesAround) {
            lines.push_back({line, text.substr(0, kLongestLine)});
        }
    }
    return lines;
}

} // namespace

ErrorReport reportOf(const Error& error, const std::string& source) {
    const SourceLocation& where = error.where();
    ErrorReport report;
    report.source = source;
    report.message = error.message();
    report.hint = error.hint();
    report.file = where.file;
    report.line = where.line;
    report.column = where.column;
    report.excerpt = excerptOf(where);
    std::smatch kernel;
    if (std::regex_search(report.message, kernel, std::regex("kernel '([a-z0-9_]+)'"))) {
        report.kernel = kernel[1].str();
    }
    return report;
}

} // namespace hyalite::live
