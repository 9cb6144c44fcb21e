// See custom_code.h.
#include "scene/yaml/custom_code.h"

#include "base/folders.h"
#include "base/input_file.h"
#include "base/spelling.h"
#include "scene/model/scene_limits.h"

#include <algorithm>
#include <cctype>
#include <regex>

namespace hyalite {

namespace {

namespace fs = std::filesystem;

bool isIdentifier(const std::string& name) {
    const auto isLetter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
    const auto isPart = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    return !name.empty() && isLetter(name.front()) && std::ranges::all_of(name, isPart) && !name.starts_with("gl_") &&
           name.find("__") == std::string::npos;
}

} // namespace

std::shared_ptr<const CustomCode> readCustomCode(const Value& file, const fs::path& folder, std::string_view type) {
    const fs::path given = file.text();
    const fs::path path = folder / given;
    if (given.extension() != ".glsl" || !isIdentifier(given.stem().string())) {
        file.fail("GLSL file " + inQuotes(given.string()) + " must be named after the function that it defines",
                  "e.g. marble.glsl for vec3 marble(...)");
    }
    if (given.is_absolute() || !isInside(path, folder)) {
        file.fail("GLSL file " + inQuotes(given.string()) + " is not in the scene file's folder or below",
                  "put it beside the scene file");
    }
    if (path.string().find_first_of("\"\\\n") != std::string::npos) {
        file.fail("the path of a GLSL file must not contain quotes, backslashes or line breaks",
                  "rename the file or its folder");
    }
    CustomCode code{.function = given.stem().string(),
                    .file = path.string(),
                    .text = readInputFile(path, kLargestCodeFile, "GLSL", file.where())};
    if (code.text.find('\0') != std::string::npos) {
        file.fail(inQuotes(given.string()) + " is not text");
    }
    if (std::regex_search(code.text, std::regex(R"((^|\n)[ \t]*#[ \t]*(include|line|version|extension))"))) {
        throw Error(ExitCode::BadInput, SourceLocation{code.file},
                    "a scene's GLSL must not use #include, #line, #version or #extension",
                    "lib/math.glsl and shared/random.h are already included");
    }
    const std::regex definition("\\b" + std::string(type) + "\\s+" + code.function + "\\s*\\(");
    std::smatch found;
    if (!std::regex_search(code.text, found, definition)) {
        throw Error(ExitCode::BadInput, SourceLocation{code.file},
                    "this file does not define the function '" + std::string(type) + ' ' + code.function + "(...)'",
                    "see docs/experiments.md for its parameters");
    }
    code.line += static_cast<int>(std::count(code.text.begin(), code.text.begin() + found.position(), '\n'));
    return std::make_shared<const CustomCode>(std::move(code));
}

void readCodeParameters(Reader& reader, glm::dvec4& parameters) {
    constexpr Range kParameter{-1e30, 1e30}; // the kernels' numbers are floats
    const auto value = reader.find("parameters");
    if (!value) {
        return;
    }
    const std::size_t count = value->list().size();
    if (count > 4) {
        value->fail("'parameters' must have at most 4 numbers");
    }
    const std::vector<double> numbers = value->numbers(count, kParameter);
    for (std::size_t i = 0; i < count; ++i) {
        parameters[static_cast<int>(i)] = numbers[i];
    }
}

} // namespace hyalite
