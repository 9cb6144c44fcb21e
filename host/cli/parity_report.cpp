#include "cli/parity_report.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace hyalite::cli {

namespace {

using parity::FieldResult;
using parity::Offender;
using parity::StageResult;

std::string shortNumber(double x) {
    std::ostringstream text;
    text << std::setprecision(2) << x;
    return text.str();
}

std::string verdictOf(const StageResult& stage) {
    if (!stage.hasTwin()) {
        return "no twin";
    }
    if (stage.failed > 0) {
        return "FAILED";
    }
    return stage.passed() ? "passed" : "too many apart";
}

// The field with the largest errors relative to their tolerance; nullptr if all fields are exact.
const FieldResult* worstField(const StageResult& stage) {
    const FieldResult* worst = nullptr;
    double largest = 0;
    for (const FieldResult& field : stage.fields) {
        if (field.ulps.empty()) {
            continue;
        }
        const double share = field.largestRelative / std::max(field.field->tolerance->relative, 1e-30);
        if (worst == nullptr || share > largest) {
            worst = &field;
            largest = share;
        }
    }
    return worst;
}

void addOffenders(std::ostream& text, const StageResult& stage) {
    for (const FieldResult& field : stage.fields) {
        for (std::size_t i = 0; i < std::min<std::size_t>(2, field.offenders.size()); ++i) {
            const Offender& offender = field.offenders[i];
            if (!offender.cause.empty()) {
                continue;
            }
            text << "  " << stage.name << ", " << offender.field << ", " << offender.where << ":\n";
            for (const Offender::Value& value : offender.answers) {
                text << "      " << value.field << ": device " << value.device << ", twin " << value.twin << '\n';
            }
            for (const auto& [name, value] : offender.inputs) {
                text << "      " << name << ": " << value << '\n';
            }
        }
    }
}

void addPaths(std::ostream& text, const std::string& name, const parity::PathResult& paths) {
    if (paths.compared == 0) {
        return;
    }
    text << name << ": " << paths.agree << " of " << paths.compared << " (" << std::setprecision(5)
         << 100 * paths.share() << " %) agree from their start within " << parity::kPathTolerance << ", "
         << 100 * paths.shareStepwise() << " % step by step";
    for (const auto& [cause, number] : paths.causes) {
        text << "; " << number << ' ' << (cause.empty() ? "UNEXPLAINED" : cause);
    }
    text << '\n';
    const parity::PhotonSum& device = paths.storedOnDevice;
    const parity::PhotonSum& twin = paths.storedByTwin;
    if (device.count + twin.count > 0) {
        text << "photons stored: " << device.count << " with " << parity::describe(device.flux) << " W on the device, "
             << twin.count << " with " << parity::describe(twin.flux) << " W by the twin\n";
    }
}

// Both sides of the first paths with an unexplained difference.
void addUnexplained(std::ostream& text, const parity::PathResult& paths, const Scene& scene) {
    constexpr std::size_t kShown = 2;
    for (std::size_t i = 0; i < std::min(kShown, paths.worst.size()) && paths.worst[i].cause.empty(); ++i) {
        text << pathTable(paths.worst[i], scene);
    }
}

} // namespace

std::string parityTable(const parity::Result& result, const Scene& scene) {
    std::ostringstream text;
    text << std::left << std::setw(24) << "stage" << std::right << std::setw(10) << "dispatches" << std::setw(11)
         << "elements" << std::setw(9) << "apart" << std::setw(9) << "failed" << std::setw(10) << "99.9 %"
         << std::setw(10) << "largest" << "  worst field\n"
         << std::string(54, ' ') << std::setw(29) << "[ulp]" << '\n';
    for (const StageResult& stage : result.stages) {
        text << std::left << std::setw(24) << stage.name << std::right << std::setw(10) << stage.dispatches
             << std::setw(11) << stage.elements << std::setw(9) << stage.apart << std::setw(9) << stage.failed;
        if (const FieldResult* worst = worstField(stage)) {
            text << std::setw(10) << shortNumber(worst->ulpPercentile(0.999)) << std::setw(10)
                 << shortNumber(worst->largestUlp) << "  " << std::left << std::setw(20) << worst->field->name;
        } else {
            text << std::setw(10) << "exact" << std::setw(10) << "" << std::setw(22) << "";
        }
        text << ' ' << verdictOf(stage) << '\n';
    }
    for (const StageResult& stage : result.stages) {
        addOffenders(text, stage);
    }
    if (result.paths) {
        addUnexplained(text, result.paths->camera, scene);
        addUnexplained(text, result.paths->photons, scene);
        addPaths(text, "camera paths", result.paths->camera);
        addPaths(text, "photon paths", result.paths->photons);
    }
    if (result.picture) {
        const parity::PictureResult& picture = *result.picture;
        text << "picture: RMSE " << shortNumber(picture.rmse) << ", relMSE " << shortNumber(picture.relMse) << ", FLIP "
             << shortNumber(picture.flip) << ", " << std::setprecision(4) << 100 * picture.shareWithin
             << " % of the pixels within " << 100 * parity::kPictureTolerance << " %\n";
    }
    return text.str();
}

std::string pathTable(const parity::RecordedPath& path, const Scene& scene) {
    std::ostringstream text;
    const std::string name = path.key.isPhoton
                                 ? "photon " + std::to_string(path.key.number)
                                 : "pixel " + std::to_string(path.key.number % scene.camera.resolution.x) + ", " +
                                       std::to_string(path.key.number / scene.camera.resolution.x) + ", pass " +
                                       std::to_string(path.key.sequence);
    const auto vertexText = [&](const char* side, const parity::Vertex& vertex) {
        const auto materialName = [&](std::uint32_t material) {
            return material < scene.materials.size() ? scene.materials[material].name : std::string("none");
        };
        text << "  " << side << '\n';
        if (vertex.object == shared::kNone) {
            text << "    hits        nothing\n";
        } else {
            text << "    hits        object " << vertex.object << ", primitive " << vertex.primitive << ", "
                 << (vertex.front ? "front" : "back") << ", " << materialName(vertex.material) << '\n'
                 << "    position    " << parity::describe(vertex.position) << '\n'
                 << "    normal      " << parity::describe(vertex.normal) << '\n';
        }
        text << (path.key.isPhoton ? "    flux        " : "    throughput  ") << parity::describe(vertex.weight)
             << '\n';
        if (!path.key.isPhoton) {
            text << "    pdf         " << parity::describe(vertex.pdfW) << '\n';
        }
        text << "    medium      " << materialName(vertex.medium) << '\n'
             << "    chosen      " << parity::describeChoice(vertex) << '\n';
    };
    const auto matching = [](const parity::Vertex& vertex) {
        return
            [&vertex](const parity::Vertex& other) { return other.depth == vertex.depth && other.seed == vertex.seed; };
    };
    for (const parity::Vertex& twin : path.twin) {
        text << "vertex " << twin.depth
             << (twin.depth == path.differsAt ? "   <-- the sides diverge here, first in " + path.what + ": " +
                                                    (path.cause.empty() ? "unexplained" : path.cause)
                                              : "")
             << '\n';
        const auto device = std::ranges::find_if(path.device, matching(twin));
        if (device != path.device.end()) {
            vertexText("device", *device);
        }
        vertexText("twin", twin);
        text << "  random numbers\n";
        for (const parity::RandomNumbers& random : parity::randomNumbersAt(scene.render.integrator, path.key, twin)) {
            text << "    " << std::left << std::setw(16) << random.purpose << parity::describe(random.numbers.x) << ' '
                 << parity::describe(random.numbers.y) << '\n';
        }
    }
    for (const parity::DeviceVertex& device : path.device) {
        if (std::ranges::none_of(path.twin, matching(device))) {
            text << "vertex " << device.depth << "   <-- only on the device\n";
            vertexText("device", device);
        }
    }
    text << name << ": "
         << (path.differsAt == 0 ? "both sides agree vertex by vertex"
                                 : "the sides diverge at vertex " + std::to_string(path.differsAt))
         << '\n';
    return text.str();
}

} // namespace hyalite::cli
