// Which requests the server answers, and how it writes addresses.
#include "live/server/access.h"

#include <catch2/catch_test_macros.hpp>

using namespace hyalite::live;

TEST_CASE("an IPv6 address is written in brackets before its port", "[live]") {
    CHECK(hostAndPort("127.0.0.1", 7878) == "127.0.0.1:7878");
    CHECK(hostAndPort("localhost", 80) == "localhost:80");
    CHECK(hostAndPort("::1", 7878) == "[::1]:7878"); // RFC 3986, section 3.2.2
    CHECK(withoutBrackets("[fe80::1]") == "fe80::1");
    CHECK(withoutBrackets("fe80::1") == "fe80::1");
    CHECK(withoutBrackets("127.0.0.1") == "127.0.0.1");
}

TEST_CASE("a server on the loopback interface answers only to its own names", "[live]") {
    const Access access("::1", 7878, "");
    for (const char* host : {"127.0.0.1:7878", "localhost:7878", "LOCALHOST:7878", "[::1]:7878"}) {
        CAPTURE(host);
        CHECK_FALSE(access.refusal({.host = host, .origin = {}, .fetchSite = {}, .token = {}, .contentType = {}}));
    }
    for (const char* host : {"evil.example:7878", "127.0.0.1", "127.0.0.1:80", "::1:7878", ""}) {
        CAPTURE(host);
        CHECK(access.refusal({.host = host, .origin = {}, .fetchSite = {}, .token = {}, .contentType = {}}));
    }
}

TEST_CASE("a server at an IPv6 address of a network answers to it", "[live]") {
    // The list of names is asked only without a token, which serve() sets for the loopback interface alone
    const Access access("2001:DB8::5", 80, "");
    CHECK_FALSE(
        access.refusal({.host = "[2001:db8::5]:80", .origin = {}, .fetchSite = {}, .token = {}, .contentType = {}}));
}
