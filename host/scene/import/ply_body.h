// The numbers after a PLY file's header, one after the other, from text or from bytes of either order. Every read
// checks that the file holds it.
#pragma once

#include "base/error.h"
#include "scene/import/ply_header.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace hyalite {

class PlyBody {
public:
    PlyBody(std::string_view file, const PlyHeader& header, std::string name)
        : bytes_(file.substr(header.bytes)), encoding_(header.encoding), name_(std::move(name)), line_(header.lines) {}

    // Bounds every later loop and allocation: throws unless the rest of the file can hold that many elements.
    void checkRoomFor(const PlyElement& element) const;

    // Tells the body which element is read next, for messages; in text an element is a line.
    void beginElement(const PlyElement& element, std::size_t index);
    void endElement();

    [[nodiscard]] double number(PlyType type); // exact: a double holds every 32-bit integer
    [[nodiscard]] std::int64_t whole(PlyType type);

    // The number of a list's items, which the rest of the file (in text, of the line) can hold.
    [[nodiscard]] std::size_t listCount(const PlyProperty& property);

    // Reads past a property's value.
    void skip(const PlyProperty& property);

    [[nodiscard]] int line() const { return encoding_ == PlyEncoding::Ascii ? line_ : 0; }
    [[nodiscard]] SourceLocation where() const { return {name_, line(), line() > 0 ? column_ : 0}; }
    [[nodiscard]] std::string of() const; // "vertex 3: ", what is being read
    [[noreturn]] void fail(const std::string& what, const std::string& hint = {}) const;

private:
    [[nodiscard]] std::string_view word();          // text: the next word of the line
    [[nodiscard]] std::uint64_t bits(PlyType type); // binary: the next value's bytes, lowest first
    [[nodiscard]] double wholeNumber(PlyType type); // text: a whole number in the type's range

    std::string_view bytes_; // not yet read; in text the lines after the present one
    PlyEncoding encoding_;
    std::string name_;
    const PlyElement* element_ = nullptr;
    std::size_t index_ = 0; // of the element
    std::string_view lineRest_;
    std::size_t lineLength_ = 0;
    int line_;
    int column_ = 1;
};

} // namespace hyalite
