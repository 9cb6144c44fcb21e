// Pictures: PNG and OpenEXR as read by compare and textures, JPEG as in glTF.
#include "fuzz/fuzz_input.h"
#include "image/exr.h"
#include "image/jpeg.h"
#include "image/png.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace hyalite;
    const std::span<const std::byte> bytes(reinterpret_cast<const std::byte*>(data), size);
    return fuzz::expectAnswer([&] {
        if (looksLikePng(bytes)) {
            static_cast<void>(decodePng(bytes, "picture"));
        } else if (looksLikeJpeg(bytes)) {
            static_cast<void>(decodeJpeg(bytes, "picture", Encoding::Srgb));
        } else if (looksLikeExr(bytes)) {
            static_cast<void>(decodeExr(bytes, "picture"));
        }
    });
}
