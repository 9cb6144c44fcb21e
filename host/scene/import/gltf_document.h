// A glTF 2.0 file taken apart: its JSON, and the bytes of its buffers wherever they are kept.
#pragma once

#include "scene/import/gltf_json.h"

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace hyalite {

class GltfDocument {
public:
    // From the bytes of a .gltf or .glb file (its first bytes say which); both must outlive the document. Buffers in
    // files of their own are looked for in `folder`. Throws Error(BadInput).
    GltfDocument(std::string_view bytes, const std::string& file, std::filesystem::path folder);

    GltfDocument(const GltfDocument&) = delete;
    GltfDocument& operator=(const GltfDocument&) = delete;

    [[nodiscard]] GltfValue root() const { return {json_, *file_}; }
    [[nodiscard]] const std::string& file() const { return *file_; }

    // The item that a reference such as a node's "mesh": 3 stands for.
    [[nodiscard]] GltfValue item(const char* list, const GltfValue& reference) const {
        return root().require(list).at(reference.index(root(), list));
    }

    // The bytes of a buffer, as many as its byteLength says; read when first asked for.
    [[nodiscard]] std::string_view buffer(std::size_t index);

    // The bytes of a buffer view.
    [[nodiscard]] std::string_view view(const GltfValue& view);

    // What the URI of an image stands for: the bytes of a data URI, or a path in the file's folder or below it.
    [[nodiscard]] std::string decodeData(const GltfValue& uri) const;
    [[nodiscard]] std::filesystem::path pathOf(const GltfValue& uri, const std::string& kind) const;

    // Of the JSON and of all buffers read so far.
    [[nodiscard]] std::size_t bytesRead() const { return bytesRead_; }

private:
    void parseBinary(std::string_view bytes);
    void parseJson(std::string_view text, bool hasLines);
    [[nodiscard]] std::string_view loadFile(const GltfValue& uri);

    const std::string* file_;
    std::filesystem::path folder_;
    nlohmann::json json_;
    std::string_view binaryChunk_; // of a .glb file
    bool hasBinaryChunk_ = false;
    std::size_t bytesRead_ = 0;
    std::map<std::size_t, std::string_view> buffers_;
    std::map<std::string, std::string> files_;    // by path
    std::map<std::size_t, std::string> embedded_; // data URIs, decoded
};

} // namespace hyalite
