#include "live/messages/page_messages.h"

namespace hyalite::live {

ChangeRequest readChangeRequest(const Json& json) {
    const auto require = [](bool holds, const char* what) {
        if (!holds) {
            throw Error(ExitCode::WrongUsage, what);
        }
    };
    require(json.is_object(), "a change must be a JSON object");
    ChangeRequest request;
    if (const auto settings = json.find("settings"); settings != json.end()) {
        require(settings->is_object(), "'settings' must be a JSON object");
        for (const auto& [key, value] : settings->items()) {
            require(value.is_null() || value.is_string(), "every value of 'settings' must be a string or null");
            request.settings[key] = value.is_null() ? std::nullopt : std::optional(value.get<std::string>());
        }
    }
    if (const auto shown = json.find("shown"); shown != json.end()) {
        require(shown->is_string(), "'shown' must be a string");
        request.shown = shown->get<std::string>();
    }
    if (const auto pixel = json.find("pixel"); pixel != json.end()) {
        require(pixel->is_number_unsigned() && pixel->get<std::uint64_t>() <= shared::kNone,
                "'pixel' must be a whole number that is not negative");
        request.pixel = pixel->get<std::uint32_t>();
    }
    if (const auto reset = json.find("reset"); reset != json.end()) {
        require(reset->is_boolean(), "'reset' must be true or false");
        request.reset = reset->get<bool>();
    }
    return request;
}

} // namespace hyalite::live
