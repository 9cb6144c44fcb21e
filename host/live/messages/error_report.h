// An error as the page shows it, with the source lines around it.
#pragma once

#include "base/error.h"
#include "live/messages/record.h"

#include <string>
#include <vector>

namespace hyalite::live {

struct SourceLine {
    int line = 0; // counts from 1
    std::string text;

    static void fields(auto& self, auto&& field) {
        field("line", self.line);
        field("text", self.text);
    }
};

struct ErrorReport {
    std::string source; // "scene", "setting", "kernel", or "worker": a kernel that brought the worker down
    std::string message;
    std::string hint;
    std::string kernel; // empty: the error is not a kernel's
    std::string file;   // path; empty: unknown
    std::string name;   // the page's name of the file; empty: the page may not read it
    int line = 0;       // counts from 1; 0: unknown
    int column = 0;     // likewise
    std::vector<SourceLine> excerpt;

    static void fields(auto& self, auto&& field) {
        field("source", self.source);
        field("message", self.message);
        field("hint", self.hint);
        field("kernel", self.kernel);
        field("file", self.file);
        field("name", self.name);
        field("line", self.line);
        field("column", self.column);
        field("excerpt", self.excerpt);
    }
};

// Reads the excerpt from the error's file. A kernel that the message names becomes the report's kernel.
[[nodiscard]] ErrorReport reportOf(const Error& error, const std::string& source);

} // namespace hyalite::live
