// Base64 by the test vectors of RFC 4648, section 10.
#include "scene/import/base64.h"

#include <catch2/catch_test_macros.hpp>

#include <string>
#include <utility>

namespace hyalite {

TEST_CASE("base64 is that of RFC 4648, in both directions") {
    using Pair = std::pair<std::string, std::string>;
    for (const auto& [bytes, text] :
         {Pair{"", ""}, Pair{"f", "Zg=="}, Pair{"fo", "Zm8="}, Pair{"foo", "Zm9v"}, Pair{"foob", "Zm9vYg=="},
          Pair{"fooba", "Zm9vYmE="}, Pair{"foobar", "Zm9vYmFy"}}) {
        CHECK(encodeBase64(bytes) == text);
        CHECK(decodeBase64(text) == bytes);
    }
    // All bits set, and every digit beyond the letters: 111110 and 111111
    CHECK(encodeBase64("\xfb\xef\xbe\xff\xff\xff") == "++++////");
}

} // namespace hyalite
