// See ply_body.h.
#include "scene/import/ply_body.h"

#include "base/numbers.h"
#include "base/spelling.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace hyalite {
namespace {

constexpr std::string_view kBlanks = " \t\r";

// Value range of a whole-number type.
std::pair<double, double> limitsOf(PlyType type) {
    const double values = std::ldexp(1.0, static_cast<int>(8 * byteSize(type)));
    const bool isSigned = type == PlyType::Int8 || type == PlyType::Int16 || type == PlyType::Int32;
    return isSigned ? std::pair{-values / 2, values / 2 - 1} : std::pair{0.0, values - 1};
}

// The number that a value's bytes stand for.
double decode(PlyType type, std::uint64_t bits) {
    switch (type) {
    case PlyType::Int8:
        return static_cast<std::int8_t>(bits);
    case PlyType::Int16:
        return static_cast<std::int16_t>(bits);
    case PlyType::Int32:
        return static_cast<std::int32_t>(bits);
    case PlyType::Float32:
        return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    case PlyType::Float64:
        return std::bit_cast<double>(bits);
    case PlyType::Uint8:
    case PlyType::Uint16:
    case PlyType::Uint32:
        break;
    }
    return static_cast<double>(bits);
}

} // namespace

std::string PlyBody::of() const {
    return element_ == nullptr ? std::string() : element_->name + ' ' + std::to_string(index_ + 1) + ": ";
}

void PlyBody::fail(const std::string& what, const std::string& hint) const {
    throw Error(ExitCode::BadInput, where(), of() + what, hint);
}

void PlyBody::checkRoomFor(const PlyElement& element) const {
    std::size_t least = 0; // bytes of one element; in text a value takes a digit and a blank or line break
    for (const PlyProperty& property : element.properties) {
        least += encoding_ == PlyEncoding::Ascii ? 2 : byteSize(property.countType.value_or(property.type));
    }
    // The last line may lack its break.
    const std::size_t room = bytes_.size() + (encoding_ == PlyEncoding::Ascii ? 1 : 0);
    if (least > 0 && element.count > room / least) {
        throw Error(ExitCode::BadInput, SourceLocation{name_, 0, 0},
                    "unexpected end of file: the header declares " + std::to_string(element.count) + " of " +
                        inQuotes(element.name),
                    "is it truncated?");
    }
}

void PlyBody::beginElement(const PlyElement& element, std::size_t index) {
    element_ = &element;
    index_ = index;
    if (encoding_ != PlyEncoding::Ascii) {
        return;
    }
    do {
        if (bytes_.empty()) {
            fail("unexpected end of file", "is it truncated?");
        }
        const std::size_t end = std::min(bytes_.find('\n'), bytes_.size());
        lineRest_ = bytes_.substr(0, end);
        lineLength_ = lineRest_.size();
        bytes_.remove_prefix(std::min(end + 1, bytes_.size()));
        ++line_;
        column_ = 1;
    } while (lineRest_.find_first_not_of(kBlanks) == std::string_view::npos); // blank lines mean nothing
}

void PlyBody::endElement() {
    const std::size_t extra = lineRest_.find_first_not_of(kBlanks);
    if (encoding_ == PlyEncoding::Ascii && extra != std::string_view::npos) {
        column_ = static_cast<int>(lineLength_ - lineRest_.size() + extra) + 1;
        fail("the line holds more values than the header names");
    }
}

std::string_view PlyBody::word() {
    const std::size_t begin = lineRest_.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos) {
        column_ = static_cast<int>(lineLength_) + 1;
        fail("the line holds fewer values than the header names");
    }
    const std::size_t end = std::min(lineRest_.find_first_of(kBlanks, begin), lineRest_.size());
    column_ = static_cast<int>(lineLength_ - lineRest_.size() + begin) + 1;
    const std::string_view text = lineRest_.substr(begin, end - begin);
    lineRest_.remove_prefix(end);
    return text;
}

std::uint64_t PlyBody::bits(PlyType type) {
    const std::size_t size = byteSize(type);
    if (bytes_.size() < size) {
        fail("unexpected end of file", "is it truncated?");
    }
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i) {
        const std::size_t place = encoding_ == PlyEncoding::BinaryLittleEndian ? i : size - 1 - i;
        value |= std::uint64_t{static_cast<unsigned char>(bytes_[i])} << (8 * place);
    }
    bytes_.remove_prefix(size);
    return value;
}

double PlyBody::wholeNumber(PlyType type) {
    const std::string_view text = word();
    const auto value = parseWhole(text);
    if (!value) {
        fail("expected a whole number, found " + inQuotes(text));
    }
    const auto [low, high] = limitsOf(type);
    const auto number = static_cast<double>(*value);
    if (number < low || number > high) {
        fail(inQuotes(text) + " does not fit the type that the header names");
    }
    return number;
}

double PlyBody::number(PlyType type) {
    if (encoding_ != PlyEncoding::Ascii) {
        return decode(type, bits(type));
    }
    if (isWholeType(type)) {
        return wholeNumber(type);
    }
    const std::string_view text = word();
    const auto value = parseNumber(text);
    if (!value) {
        fail("expected a number, found " + inQuotes(text));
    }
    return *value;
}

std::int64_t PlyBody::whole(PlyType type) {
    if (!isWholeType(type)) {
        fail("an index must have a whole-number type");
    }
    return static_cast<std::int64_t>(number(type));
}

std::size_t PlyBody::listCount(const PlyProperty& property) {
    const std::int64_t count = whole(*property.countType);
    if (count < 0) {
        fail("the list " + inQuotes(property.name) + " has a negative count");
    }
    const bool isText = encoding_ == PlyEncoding::Ascii;
    const std::size_t room = isText ? lineRest_.size() / 2 : bytes_.size() / byteSize(property.type);
    if (static_cast<std::uint64_t>(count) > room) {
        fail("the list " + inQuotes(property.name) + " declares " + std::to_string(count) + " values, but the " +
                 (isText ? "line" : "file") + " ends first",
             "is the file truncated?");
    }
    return static_cast<std::size_t>(count);
}

void PlyBody::skip(const PlyProperty& property) {
    const std::size_t values = property.countType ? listCount(property) : 1;
    for (std::size_t i = 0; i < values; ++i) {
        static_cast<void>(number(property.type));
    }
}

} // namespace hyalite
