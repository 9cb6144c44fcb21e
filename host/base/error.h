// The one exception of the program: what went wrong, where in a file, and how to mend it.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace hyalite {

// Exit codes of the command line; every Error names the one it leads to.
enum class ExitCode : int {
    Done = 0,
    ComparisonFailed = 1,
    WrongUsage = 2,
    BadInput = 3,
    Device = 4,
    OutputNotWritten = 5,
    Interrupted = 6,
};

// A place in a text file; line and column count from 1, 0 means unknown.
struct SourceLocation {
    std::string file;
    int line = 0;
    int column = 0;
};

class Error : public std::runtime_error {
public:
    Error(ExitCode code, const std::string& what, std::string hint = {})
        : Error(code, SourceLocation{}, what, std::move(hint)) {}

    Error(ExitCode code, SourceLocation where, const std::string& what, std::string hint = {})
        : std::runtime_error(format(where, what, hint)), code_(code), where_(std::move(where)), message_(what),
          hint_(std::move(hint)) {}

    [[nodiscard]] ExitCode code() const { return code_; }
    [[nodiscard]] const SourceLocation& where() const { return where_; }
    // Only what went wrong; what() has the place and the hint too.
    [[nodiscard]] const std::string& message() const { return message_; }
    [[nodiscard]] const std::string& hint() const { return hint_; }

private:
    // "file:line:column: what (hint)", leaving out what is not known.
    static std::string format(const SourceLocation& where, const std::string& what, const std::string& hint) {
        std::string text = where.file;
        if (where.line > 0) {
            text += ':' + std::to_string(where.line);
            if (where.column > 0) {
                text += ':' + std::to_string(where.column);
            }
        }
        if (!text.empty()) {
            text += ": ";
        }
        text += what;
        if (!hint.empty()) {
            text += " (" + hint + ')';
        }
        return text;
    }

    ExitCode code_;
    SourceLocation where_;
    std::string message_;
    std::string hint_;
};

} // namespace hyalite
