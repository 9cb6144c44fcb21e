// Who may speak to the server. A web page from elsewhere can send requests to an address of this machine, under a name
// of its own that resolves to it too; so a request must name the server as its user does, come from its own page if it
// comes from one, and, where the server listens to other machines, know the token.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace hyalite::live {

struct Request {
    std::string host;      // of the header, "127.0.0.1:7878"
    std::string origin;    // likewise; empty: none
    std::string fetchSite; // Sec-Fetch-Site; empty: none
    std::string token;     // as it was given, in the address or a cookie; empty: none
    bool writes = false;   // any method but GET and HEAD
    std::string contentType;
};

class Access {
public:
    // On the loopback interface alone: `token` is empty. Else `address` is what it listens at.
    Access(const std::string& address, int port, std::string token);

    // Why the request is refused; nothing: it is not.
    [[nodiscard]] std::optional<std::string> refusal(const Request& request) const;

    [[nodiscard]] bool needsToken() const { return !token_.empty(); }
    [[nodiscard]] const std::string& token() const { return token_; }

private:
    std::vector<std::string> hosts_; // that the header may name; where a token is needed, any
    std::string token_;
};

// 128 bits from the system's source of randomness, as hexadecimal digits.
[[nodiscard]] std::string randomToken();

[[nodiscard]] bool isLoopback(const std::string& address);

} // namespace hyalite::live
