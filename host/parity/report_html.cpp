// The page is report.html with data inserted: JSON read by its script, and pictures as data URIs.
#include "parity/report.h"

#include "image/png.h"
#include "parity/checks/checks.h"
#include "scene/import/base64.h"

#include "parity/report_template.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace hyalite::parity {

namespace {

using Json = nlohmann::ordered_json;

// Seven digits are enough for the precision of a float, and keep the page small.
void append(std::string& text, double x) {
    std::array<char, 32> digits{};
    const int length = std::snprintf(digits.data(), digits.size(), "%.7g", std::isfinite(x) ? x : 0.0);
    text.append(digits.data(), static_cast<std::size_t>(length));
    text += ',';
}

void append(std::string& text, const glm::dvec3& v) {
    append(text, v.x);
    append(text, v.y);
    append(text, v.z);
}

double orMinusOne(std::uint32_t index) {
    return index == shared::kNone ? -1 : static_cast<double>(index);
}

// A vertex as a list of numbers, in the order given in report.html.
void append(std::string& text, const Vertex& vertex) {
    text += '[';
    append(text, vertex.depth);
    append(text, vertex.seed);
    append(text, orMinusOne(vertex.object));
    append(text, vertex.primitive);
    append(text, orMinusOne(vertex.material));
    append(text, vertex.front ? 1 : 0);
    append(text, orMinusOne(vertex.medium));
    append(text, vertex.choice);
    append(text, vertex.position);
    append(text, vertex.normal);
    append(text, vertex.weight);
    append(text, vertex.pdfW);
    text.back() = ']';
    text += ',';
}

// Limit on the vertices shown per path, lowered if all paths together have too many: a vertex takes about 600 bytes,
// and Whitted's trees have hundreds of branches.
constexpr std::size_t kVerticesOfPath = 24;
constexpr std::size_t kVerticesOfPage = 16384;

std::size_t verticesShown(const std::vector<RecordedPath>& paths) {
    for (std::size_t most = kVerticesOfPath; most > 1; --most) {
        std::size_t sum = 0;
        for (const RecordedPath& path : paths) {
            sum += std::min(path.twin.size(), most);
        }
        if (sum <= kVerticesOfPage) {
            return most;
        }
    }
    return 1;
}

template <class Vertices>
void appendList(std::string& text, const Vertices& vertices, std::size_t most) {
    text += '[';
    for (const auto& vertex : std::span(vertices).first(std::min(vertices.size(), most))) {
        append(text, vertex);
    }
    text += vertices.empty() ? "]" : "";
    if (!vertices.empty()) {
        text.back() = ']';
    }
    text += ',';
}

// {"k": [photon?, sequence, number], "d": device, "t": twin, "r": random numbers by twin's vertex, "n": vertices
// in all, "x": first difference}
void append(std::string& text, std::string_view integrator, const RecordedPath& path, std::size_t most) {
    text += "{\"k\":[" + std::to_string(path.key.isPhoton ? 1 : 0) + ',' + std::to_string(path.key.sequence) + ',' +
            std::to_string(path.key.number) + "],\"d\":";
    appendList(text, path.device, most);
    text += "\"t\":";
    appendList(text, path.twin, most);
    text += "\"r\":[";
    for (const Vertex& vertex : std::span(path.twin).first(std::min(path.twin.size(), most))) {
        text += '[';
        for (const RandomNumbers& random : randomNumbersAt(integrator, path.key, vertex)) {
            append(text, random.numbers.x);
            append(text, random.numbers.y);
        }
        text.back() = ']';
        text += ',';
    }
    if (!path.twin.empty()) {
        text.pop_back();
    }
    text += "],\"n\":" + std::to_string(std::max(path.device.size(), path.twin.size()));
    if (path.differsAt != 0) {
        text += ",\"x\":" + Json{path.differsAt, path.what, path.cause.empty() ? "unexplained" : path.cause}.dump();
    }
    text += "},";
}

std::string listOf(std::string_view integrator, const std::vector<RecordedPath>& paths) {
    const std::size_t most = verticesShown(paths);
    std::string text = "[";
    for (const RecordedPath& path : paths) {
        append(text, integrator, path, most);
    }
    if (!paths.empty()) {
        text.pop_back();
    }
    return text + ']';
}

// Scales the map so that its largest error, or a just visible error if that is larger, is white.
ErrorMap brightened(ErrorMap map, double white) {
    for (double& value : map.values) {
        value /= white;
    }
    return map;
}

std::string dataUri(const Image& image) {
    const std::vector<std::byte> png = encodePng(image);
    return "data:image/png;base64," + encodeBase64({reinterpret_cast<const char*>(png.data()), png.size()});
}

Json namesOf(const Scene& scene) {
    constexpr std::array<const char*, 8> kShapes{"sphere", "quad", "disk", "plane", "quadric", "torus", "mesh", "csg"};
    Json names{{"objects", Json::array()}, {"materials", Json::array()}};
    for (const Object& object : scene.objects) {
        names["objects"].push_back(kShapes.at(object.shape.index()));
    }
    for (const Material& material : scene.materials) {
        names["materials"].push_back(material.name);
    }
    return names;
}

Json tolerances() {
    Json list = Json::array();
    for (const Check* check : allChecks()) {
        check->forEachField([&](const Field& field) {
            list.push_back({check->kernel, field.name, field.tolerance->relative, field.tolerance->reason});
        });
    }
    return list;
}

void replace(std::string& text, std::string_view what, std::string_view by) {
    const std::size_t at = text.find(what);
    text.replace(at, what.size(), by);
}

// A script must not contain "</script>", even if a name does.
std::string safe(std::string json) {
    for (std::size_t at = json.find("</"); at != std::string::npos; at = json.find("</", at + 3)) {
        json.replace(at, 2, "<\\/");
    }
    return json;
}

} // namespace

std::string toHtml(const Result& result, const Scene& scene, const Circumstances& circumstances) {
    Json pictures = Json::object();
    if (result.picture) {
        constexpr double kLeastWhite = 0.01;
        const auto& errors = result.picture->flipMap.values;
        const double white = std::max(kLeastWhite, *std::ranges::max_element(errors));
        const ErrorMap shown = brightened(result.picture->flipMap, white);
        pictures = {{"width", result.picture->twin.width},
                    {"height", result.picture->twin.height},
                    {"device", dataUri(result.picture->device)},
                    {"twin", dataUri(result.picture->twin)},
                    {"difference", dataUri(falseColour(shown, wholeOf(result.picture->twin)))},
                    {"white", white}};
    }
    std::vector<RecordedPath> worst;
    if (result.paths) {
        worst = result.paths->camera.worst;
        worst.insert(worst.end(), result.paths->photons.worst.begin(), result.paths->photons.worst.end());
    }
    std::string page(kReportTemplate);
    replace(page, "\"@RESULT@\"", safe(toJson(result, circumstances)));
    replace(page, "\"@PICTURES@\"", pictures.dump());
    replace(page, "\"@NAMES@\"", safe(namesOf(scene).dump()));
    replace(page, "\"@TOLERANCES@\"", safe(tolerances().dump()));
    replace(page, "\"@WORST@\"", listOf(scene.render.integrator, worst));
    replace(page, "\"@PIXELS@\"", listOf(scene.render.integrator, result.shown));
    return page;
}

} // namespace hyalite::parity
