// See gltf_document.h.
#include "scene/import/gltf_document.h"

#include "base/input_file.h"
#include "base/little_endian.h"
#include "base/spelling.h"
#include "scene/import/base64.h"
#include "scene/model/scene_limits.h"

#include <algorithm>

namespace hyalite {
namespace {

constexpr std::string_view kBinaryMagic = "glTF";
constexpr std::size_t kHeaderBytes = 12; // magic, version, length of the file
constexpr std::size_t kChunkHeaderBytes = 8;
constexpr std::uint32_t kJsonChunk = 0x4e4f534aU;   // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004e4942U; // "BIN\0"

// Decodes percent signs, "%20" to a blank; none where a percent sign is followed by anything but two digits.
std::optional<std::string> decodePercent(std::string_view text) {
    const auto digit = [](char c) { return std::string_view("0123456789abcdef").find(lowerCase({&c, 1})); };
    std::string decoded;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            decoded += text[i];
            continue;
        }
        const std::size_t high = i + 2 < text.size() ? digit(text[i + 1]) : std::string_view::npos;
        const std::size_t low = high != std::string_view::npos ? digit(text[i + 2]) : std::string_view::npos;
        if (low == std::string_view::npos) {
            return std::nullopt;
        }
        decoded += static_cast<char>(16 * high + low);
        i += 2;
    }
    return decoded;
}

// Whether a path leads no higher than the folder it starts from.
bool staysInside(const std::filesystem::path& path) {
    return !path.empty() && path.is_relative() && !path.has_root_name() &&
           std::find(path.begin(), path.end(), "..") == path.end();
}

} // namespace

GltfDocument::GltfDocument(std::string_view bytes, const std::string& file, std::filesystem::path folder)
    : file_(&file), folder_(std::move(folder)) {
    if (bytes.starts_with(kBinaryMagic)) {
        parseBinary(bytes);
    } else {
        parseJson(bytes, true);
    }
    const GltfValue version = root().require("asset").require("version");
    if (!version.text().starts_with("2.")) {
        version.fail("glTF " + inQuotes(version.text()) + " is not supported", "export the file as glTF 2.0");
    }
}

void GltfDocument::parseBinary(std::string_view bytes) {
    const auto fail = [&](std::size_t at, const std::string& what) {
        throw Error(ExitCode::BadInput, SourceLocation{*file_, 0, 0}, "byte " + std::to_string(at) + ": " + what,
                    "is the file truncated?");
    };
    if (bytes.size() < kHeaderBytes) {
        fail(bytes.size(), "unexpected end of file in the header");
    }
    if (const std::uint32_t version = littleEndian(bytes.substr(4, 4)); version != 2) {
        throw Error(ExitCode::BadInput, SourceLocation{*file_, 0, 0},
                    "binary glTF version " + std::to_string(version) + " is not supported",
                    "export the file as glTF 2.0");
    }
    if (const std::uint32_t length = littleEndian(bytes.substr(8, 4)); length != bytes.size()) {
        fail(8,
             "the header declares " + std::to_string(length) + " bytes, the file has " + std::to_string(bytes.size()));
    }
    bool hasJson = false;
    for (std::size_t at = kHeaderBytes; at < bytes.size();) {
        if (bytes.size() - at < kChunkHeaderBytes) {
            fail(at, "unexpected end of file in the header of a chunk");
        }
        const std::size_t length = littleEndian(bytes.substr(at, 4));
        const std::uint32_t type = littleEndian(bytes.substr(at + 4, 4));
        const std::size_t begin = at + kChunkHeaderBytes;
        if (length > bytes.size() - begin) {
            fail(at, "a chunk of " + std::to_string(length) + " bytes goes beyond the end of the file");
        }
        const std::string_view chunk = bytes.substr(begin, length);
        if (!hasJson) {
            if (type != kJsonChunk) {
                fail(at, "the first chunk is not JSON");
            }
            parseJson(chunk, false);
            hasJson = true;
        } else if (type == kBinaryChunk && !hasBinaryChunk_) {
            binaryChunk_ = chunk;
            hasBinaryChunk_ = true;
            bytesRead_ += chunk.size();
        } // chunks of other types are extensions that a reader skips
        at = begin + length;
    }
    if (!hasJson) {
        fail(bytes.size(), "there is no JSON chunk");
    }
}

void GltfDocument::parseJson(std::string_view text, bool hasLines) {
    bytesRead_ += text.size();
    try {
        json_ = nlohmann::json::parse(text);
    } catch (const nlohmann::json::parse_error& error) {
        // Of the library's message, "[...] parse error at line 1, column 2: what", the last part.
        std::string what = error.what();
        const std::size_t begin = what.find(": ");
        what = begin == std::string::npos ? what : what.substr(begin + 2);
        const std::string_view before = text.substr(0, error.byte > 0 ? error.byte - 1 : 0);
        const auto line = static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1;
        const std::size_t lineBegin = before.rfind('\n') + 1; // 0 where there is none
        const auto column = static_cast<int>(before.size() - lineBegin) + 1;
        throw Error(ExitCode::BadInput, SourceLocation{*file_, hasLines ? line : 0, hasLines ? column : 0},
                    "JSON: " + what, "a .gltf file is JSON, a .glb file begins with 'glTF'");
    } catch (const nlohmann::json::exception& error) { // a number that no double holds
        throw Error(ExitCode::BadInput, SourceLocation{*file_, 0, 0}, std::string("JSON: ") + error.what());
    }
}

std::string_view GltfDocument::buffer(std::size_t index) {
    if (const auto known = buffers_.find(index); known != buffers_.end()) {
        return known->second;
    }
    const GltfValue buffer = root().require("buffers").at(index);
    const auto uri = buffer.find("uri");
    std::string_view bytes;
    if (!uri) {
        if (index != 0 || !hasBinaryChunk_) {
            buffer.fail("missing 'uri', and there is no binary chunk for it");
        }
        bytes = binaryChunk_;
    } else if (uri->text().starts_with("data:")) {
        bytes = embedded_.emplace(index, decodeData(*uri)).first->second;
        bytesRead_ += bytes.size();
    } else {
        bytes = loadFile(*uri);
    }
    const GltfValue length = buffer.require("byteLength");
    if (length.whole(1) > bytes.size()) {
        length.fail("the buffer declares " + std::to_string(length.whole()) + " bytes, but holds " +
                        std::to_string(bytes.size()),
                    "is the file truncated?");
    }
    return buffers_.emplace(index, bytes.substr(0, length.whole())).first->second;
}

std::string_view GltfDocument::view(const GltfValue& view) {
    const std::string_view bytes = buffer(view.require("buffer").index(root(), "buffers"));
    const auto offset = view.find("byteOffset");
    const std::size_t begin = offset ? offset->whole() : 0;
    const std::size_t length = view.require("byteLength").whole(1);
    if (begin > bytes.size() || length > bytes.size() - begin) {
        view.fail(std::to_string(length) + " bytes from byte " + std::to_string(begin) +
                  " go beyond the end of its buffer of " + std::to_string(bytes.size()) + " bytes");
    }
    return bytes.substr(begin, length);
}

std::string GltfDocument::decodeData(const GltfValue& uri) const {
    const std::string_view text = uri.text();
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos || !text.substr(0, comma).ends_with(";base64")) {
        uri.fail("a data URI must be base64");
    }
    auto decoded = decodeBase64(text.substr(comma + 1));
    if (!decoded) {
        uri.fail("the data URI is not valid base64");
    }
    return *std::move(decoded);
}

std::filesystem::path GltfDocument::pathOf(const GltfValue& uri, const std::string& kind) const {
    const auto name = decodePercent(uri.text());
    const bool isPlain = name && std::none_of(name->begin(), name->end(), [](char c) {
                             return static_cast<unsigned char>(c) < 0x20 || c == '\\' || c == ':';
                         });
    if (!isPlain || !staysInside(*name)) {
        uri.fail("the " + kind + ' ' + inQuotes(uri.text()) +
                     " must be a file in the folder of the glTF file, or below it",
                 "a relative path without '..', or a data URI");
    }
    return folder_ / *name;
}

std::string_view GltfDocument::loadFile(const GltfValue& uri) {
    const std::filesystem::path path = pathOf(uri, "buffer");
    const auto [known, isNew] = files_.try_emplace(path.lexically_normal().string());
    if (isNew) {
        known->second = readInputFile(path, kLargestMeshFile, "buffer", SourceLocation{*file_, 0, 0});
        bytesRead_ += known->second.size();
    }
    return known->second;
}

} // namespace hyalite
