#include "live/server/access.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <random>

namespace hyalite::live {

namespace {

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

// Takes the same time wherever the texts differ, so that the time does not help to guess a token.
bool isSame(const std::string& a, const std::string& b) {
    unsigned difference = a.size() == b.size() ? 0 : 1;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        difference |= static_cast<unsigned>(static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]));
    }
    return difference == 0;
}

} // namespace

Access::Access(const std::string& address, int port, std::string token) : token_(std::move(token)) {
    for (const std::string& name : {std::string("127.0.0.1"), std::string("localhost"), std::string("::1"), address}) {
        hosts_.push_back(lower(hostAndPort(name, port)));
    }
}

std::optional<std::string> Access::refusal(const Request& request) const {
    const std::string host = lower(request.host);
    // A page from elsewhere can choose the name in Host, but it does not know the token
    if (token_.empty() && std::ranges::find(hosts_, host) == hosts_.end()) {
        return "this server does not answer to the name '" + request.host + "'";
    }
    if (!request.origin.empty() && lower(request.origin) != "http://" + host) {
        return "requests from other pages are refused";
    }
    if (!request.fetchSite.empty() && request.fetchSite != "same-origin" && request.fetchSite != "none") {
        return "requests from other pages are refused";
    }
    if (request.writes && !request.contentType.starts_with("application/json")) {
        return "the request's content must be JSON";
    }
    if (!token_.empty() && !isSame(request.token, token_)) {
        return "the token is missing or wrong: open the address that hyalite live printed";
    }
    return std::nullopt;
}

std::string randomToken() {
    std::random_device source;
    std::string token;
    for (int word = 0; word < 4; ++word) {
        std::array<char, 9> digits{};
        std::snprintf(digits.data(), digits.size(), "%08x", source());
        token += digits.data();
    }
    return token;
}

bool isLoopback(const std::string& address) {
    return address == "localhost" || address == "::1" || address.starts_with("127.");
}

std::string hostAndPort(const std::string& address, int port) {
    const bool isIpv6 = address.find(':') != std::string::npos;
    return (isIpv6 ? '[' + address + ']' : address) + ':' + std::to_string(port);
}

std::string withoutBrackets(const std::string& address) {
    const bool hasBrackets = address.starts_with('[') && address.ends_with(']');
    return hasBrackets ? address.substr(1, address.size() - 2) : address;
}

} // namespace hyalite::live
