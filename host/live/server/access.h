// Decides which requests the server answers. Any web page can make the browser send requests to this machine, even
// under a name of its own that it lets resolve to this machine's address (DNS rebinding). So the server checks three
// things: the Host header names the server as its user does; a request from a page comes from the server's own page;
// and, when the server listens to other machines, the request knows the token.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace hyalite::live {

struct Request {
    std::string host;      // header Host, "127.0.0.1:7878"
    std::string origin;    // header Origin; empty: none
    std::string fetchSite; // header Sec-Fetch-Site; empty: none
    std::string token;     // from the address or a cookie; empty: none
    bool writes = false;   // any method other than GET and HEAD
    std::string contentType;
};

class Access {
public:
    // `address`, `port`: where the server listens. `token`: empty when it listens to this machine alone.
    Access(const std::string& address, int port, std::string token);

    // Why the request is refused; nothing when it is accepted.
    [[nodiscard]] std::optional<std::string> refusal(const Request& request) const;

    [[nodiscard]] bool needsToken() const { return !token_.empty(); }
    [[nodiscard]] const std::string& token() const { return token_; }

private:
    std::vector<std::string> hosts_; // that the Host header may name; with a token it may name any
    std::string token_;
};

// 128 bits from the system's random source, as hexadecimal digits.
[[nodiscard]] std::string randomToken();

[[nodiscard]] bool isLoopback(const std::string& address);

// "127.0.0.1:80", and for an IPv6 address "[::1]:80", as URLs and the Host header write it.
[[nodiscard]] std::string hostAndPort(const std::string& address, int port);
// "::1" of "[::1]"; any other address as it is.
[[nodiscard]] std::string withoutBrackets(const std::string& address);

} // namespace hyalite::live
