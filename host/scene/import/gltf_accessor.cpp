// See gltf_accessor.h.
#include "scene/import/gltf_accessor.h"

#include "base/little_endian.h"
#include "base/spelling.h"

#include <algorithm>
#include <array>
#include <bit>

namespace hyalite {
namespace {

// Component types by their OpenGL numbers.
constexpr std::uint64_t kInt8 = 5120;
constexpr std::uint64_t kUint8 = 5121;
constexpr std::uint64_t kInt16 = 5122;
constexpr std::uint64_t kUint16 = 5123;
constexpr std::uint64_t kUint32 = 5125;
constexpr std::uint64_t kFloat32 = 5126;

std::size_t bytesOf(const GltfValue& componentType) {
    switch (componentType.whole()) {
    case kInt8:
    case kUint8:
        return 1;
    case kInt16:
    case kUint16:
        return 2;
    case kUint32:
    case kFloat32:
        return 4;
    default:
        componentType.fail("unknown component type " + std::to_string(componentType.whole()),
                           "known: 5120, 5121, 5122, 5123, 5125, 5126");
    }
}

bool isIndexType(std::uint64_t componentType) {
    return componentType == kUint8 || componentType == kUint16 || componentType == kUint32;
}

} // namespace

GltfAccessor::GltfAccessor(GltfDocument& document, const GltfValue& reference, std::string_view type)
    : value_(document.item("accessors", reference)) {
    const GltfValue itsType = value_.require("type");
    if (itsType.text() != type) {
        itsType.fail("'" + reference.place() + "' needs an accessor of type " + inQuotes(type) + ", found " +
                     inQuotes(itsType.text()));
    }
    constexpr std::array<std::string_view, 4> kTypes{"SCALAR", "VEC2", "VEC3", "VEC4"};
    components_ = static_cast<std::size_t>(std::find(kTypes.begin(), kTypes.end(), type) - kTypes.begin()) + 1;
    const GltfValue componentType = value_.require("componentType");
    componentBytes_ = bytesOf(componentType);
    componentType_ = componentType.whole();
    const auto normalized = value_.find("normalized");
    isNormalized_ = normalized && normalized->truth();
    count_ = value_.require("count").whole(1);

    if (value_.find("bufferView")) {
        base_ = open(document, value_, count_, components_ * componentBytes_, true);
    } else if (count_ > document.bytesRead()) { // zeros take no room in the file, but what is made of them does
        value_.fail(std::to_string(count_) + " elements without a buffer view in a file of " +
                    std::to_string(document.bytesRead()) + " bytes");
    }
    if (const auto sparse = value_.find("sparse")) {
        readSparse(document, *sparse);
    }
}

// Elements of a buffer view: `where` names the view and the offset in it.
GltfAccessor::View GltfAccessor::open(GltfDocument& document, const GltfValue& where, std::size_t count,
                                      std::size_t elementBytes, bool mayStride) {
    const GltfValue view = document.item("bufferViews", where.require("bufferView"));
    const std::string_view bytes = document.view(view);
    const std::size_t length = bytes.size();

    std::size_t stride = elementBytes;
    if (const auto written = view.find("byteStride"); written && mayStride) {
        stride = written->whole(1, 252); // the format's limit
        if (stride < elementBytes) {
            written->fail("elements of " + std::to_string(elementBytes) + " bytes overlap at a stride of " +
                          std::to_string(stride));
        }
    }
    const auto elementOffset = where.find("byteOffset");
    const std::size_t offset = elementOffset ? elementOffset->whole() : 0;
    // count <= length keeps the product below from overflowing.
    if (offset > length || count > length || (count - 1) * stride + elementBytes > length - offset) {
        where.fail(std::to_string(count) + " elements of " + std::to_string(elementBytes) + " bytes, one every " +
                   std::to_string(stride) + " from byte " + std::to_string(offset) + ", go beyond the end of '" +
                   view.place() + "' of " + std::to_string(length) + " bytes");
    }
    return {bytes.substr(offset, (count - 1) * stride + elementBytes), stride};
}

void GltfAccessor::readSparse(GltfDocument& document, const GltfValue& sparse) {
    const std::size_t count = sparse.require("count").whole(1, count_);
    const GltfValue indices = sparse.require("indices");
    const GltfValue type = indices.require("componentType");
    const std::size_t indexBytes = bytesOf(type);
    if (!isIndexType(type.whole())) {
        type.fail("indices must be whole numbers without sign");
    }
    const View view = open(document, indices, count, indexBytes, false);
    sparseElements_.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t element = littleEndian(view.bytes.substr(i * indexBytes, indexBytes));
        if (element >= count_ || (i > 0 && element <= sparseElements_.back())) {
            indices.fail("number " + std::to_string(i) + " of them is " + std::to_string(element),
                         "they must ascend and be below " + std::to_string(count_));
        }
        sparseElements_.push_back(element);
    }
    sparseValues_ = open(document, sparse.require("values"), count, components_ * componentBytes_, false);
}

double GltfAccessor::decode(std::string_view bytes) const {
    const std::uint32_t bits = littleEndian(bytes);
    double value = bits;
    double largest = 1;
    switch (componentType_) {
    case kFloat32:
        return static_cast<double>(std::bit_cast<float>(bits));
    case kInt8:
        value = static_cast<std::int8_t>(bits);
        largest = 127;
        break;
    case kInt16:
        value = static_cast<std::int16_t>(bits);
        largest = 32767;
        break;
    case kUint8:
        largest = 255;
        break;
    case kUint16:
        largest = 65535;
        break;
    default:
        largest = 4294967295.0;
        break;
    }
    return isNormalized_ ? std::max(value / largest, -1.0) : value;
}

double GltfAccessor::component(std::size_t element, std::size_t component) const {
    const std::size_t offset = component * componentBytes_;
    const auto sparse = std::lower_bound(sparseElements_.begin(), sparseElements_.end(), element);
    if (sparse != sparseElements_.end() && *sparse == element) {
        const auto place = static_cast<std::size_t>(sparse - sparseElements_.begin());
        return decode(sparseValues_.bytes.substr(place * sparseValues_.stride + offset, componentBytes_));
    }
    return base_.bytes.empty() ? 0 : decode(base_.bytes.substr(element * base_.stride + offset, componentBytes_));
}

std::uint32_t GltfAccessor::index(std::size_t element) const {
    return static_cast<std::uint32_t>(component(element, 0));
}

void GltfAccessor::requireIndices() const {
    if (!isIndexType(componentType_) || isNormalized_) {
        value_.require("componentType").fail("indices must be whole numbers without sign");
    }
}

void GltfAccessor::fail(std::size_t element, const std::string& what, const std::string& hint) const {
    value_.fail("element " + std::to_string(element) + ": " + what, hint);
}

} // namespace hyalite
