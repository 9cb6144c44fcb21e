// A copy of the source tree's shaders that a test may extend and break; removed by its destructor.
#pragma once

#include <filesystem>
#include <string>

namespace hyalite::testing {

class TemporaryShaders {
public:
    TemporaryShaders();
    ~TemporaryShaders();
    TemporaryShaders(const TemporaryShaders&) = delete;
    TemporaryShaders& operator=(const TemporaryShaders&) = delete;

    // Holds shaders/ and, for the test's own use, nothing else.
    [[nodiscard]] const std::filesystem::path& root() const { return root_; }
    [[nodiscard]] std::filesystem::path shaders() const { return root_ / "shaders"; }

    // Writes a file, given by its path from the shaders folder.
    void write(const std::string& file, const std::string& text) const;
    // Writes kernels/<name>.comp with `body` as its main, run once for each thread i below args.count. `members` are
    // the lines of its Arguments struct before the count; `declarations` stand before main.
    void writeKernel(const std::string& name, const std::string& members, const std::string& body,
                     const std::string& declarations = {}) const;
    // Replaces the one place of `old` in a file.
    void replace(const std::string& file, const std::string& old, const std::string& text) const;

private:
    std::filesystem::path root_;
};

[[nodiscard]] std::string readFile(const std::filesystem::path& file);
void writeFile(const std::filesystem::path& file, const std::string& bytes);

} // namespace hyalite::testing
