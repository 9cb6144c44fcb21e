// The numbers behind a glTF accessor: strided, sparse, normalised or not, of any component type, and checked to lie
// within their buffers before one is read.
#pragma once

#include "scene/import/gltf_document.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hyalite {

class GltfAccessor {
public:
    // What `reference` (the index of an accessor) stands for; its type must be `type` ("SCALAR", "VEC2", "VEC3").
    // Throws Error(BadInput). References the document.
    GltfAccessor(GltfDocument& document, const GltfValue& reference, std::string_view type);

    [[nodiscard]] std::size_t size() const { return count_; }

    // A component of an element, normalised where the accessor says so; element < size().
    [[nodiscard]] double component(std::size_t element, std::size_t component) const;

    // An element of an accessor of indices: of one component, a whole number without sign.
    [[nodiscard]] std::uint32_t index(std::size_t element) const;
    void requireIndices() const;

    // Throws Error(BadInput) about an element.
    [[noreturn]] void fail(std::size_t element, const std::string& what, const std::string& hint = {}) const;

private:
    // Elements in a buffer, one every `stride` bytes.
    struct View {
        std::string_view bytes; // empty: all elements are 0
        std::size_t stride = 0;
    };

    void readSparse(GltfDocument& document, const GltfValue& sparse);
    [[nodiscard]] static View open(GltfDocument& document, const GltfValue& where, std::size_t count,
                                   std::size_t elementBytes, bool mayStride);
    [[nodiscard]] double decode(std::string_view bytes) const;

    GltfValue value_;
    std::uint64_t componentType_ = 0;
    std::size_t componentBytes_ = 0;
    std::size_t components_ = 1;
    bool isNormalized_ = false;
    std::size_t count_ = 0;
    View base_;
    std::vector<std::uint32_t> sparseElements_; // ascending
    View sparseValues_;
};

} // namespace hyalite
