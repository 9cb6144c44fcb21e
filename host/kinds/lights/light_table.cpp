// See light_table.h.
#include "kinds/lights/light_table.h"

#include "kinds/lights/light_kinds.h"
#include "scene/model/bounds.h"

#include <numbers>

namespace hyalite::kinds {

using std::numbers::pi;

double channelMean(const glm::dvec3& c) {
    return (c.x + c.y + c.z) / 3;
}

double appendCdf(std::vector<float>& cdfs, const std::vector<double>& weights) {
    double total = 0;
    for (const double weight : weights) {
        total += weight;
    }
    double sum = 0;
    for (const double weight : weights) {
        sum += total > 0 ? weight / total : 1.0 / static_cast<double>(weights.size());
        cdfs.push_back(static_cast<float>(sum));
    }
    cdfs.back() = 1; // remove the rounding error
    return total;
}

void LightTable::add(const shared::LightRecord& light, double share) {
    lights.push_back(light);
    weights.push_back(channelMean(light.power) * share);
}

void setStartDisc(shared::LightRecord& r, double radius, double distance) {
    r.radius = static_cast<float>(radius);
    r.distance = static_cast<float>(distance);
    r.area = static_cast<float>(pi * radius * radius);
}

shared::LightRecord endlessLight(const Scene& scene, std::uint32_t type) {
    const LightSphere sphere = lightSphere(scene);
    shared::LightRecord r{};
    r.type = type;
    r.position = sphere.center;
    setStartDisc(r, sphere.radius, sphere.distance);
    return r;
}

namespace {

void setProbabilities(LightTable& table) {
    double total = 0;
    for (const double weight : table.weights) {
        total += weight;
    }
    double sum = 0;
    for (std::size_t i = 0; i < table.weights.size(); ++i) {
        sum += table.weights[i];
        table.lights[i].pmf = static_cast<float>(table.weights[i] / total);
        table.lights[i].cdf = static_cast<float>(sum / total);
    }
    if (!table.lights.empty()) {
        table.lights.back().cdf = 1;
    }
}

} // namespace

LightTable buildLightTable(const Scene& scene) {
    LightTable table;
    for (const LightKind* kind : kLightKinds) {
        if (kind->addRecords != nullptr) {
            kind->addRecords(scene, table);
        }
    }
    setProbabilities(table);
    return table;
}

void setAddresses(std::vector<shared::LightRecord>& lights, shared::LightTriangleArray triangles,
                  shared::RadianceArray texels, shared::CdfArray cdfs) {
    for (shared::LightRecord& light : lights) {
        light.triangles.address += triangles.address;
        light.texels.address += texels.address;
        light.cdfs.address += cdfs.address;
    }
}

} // namespace hyalite::kinds
