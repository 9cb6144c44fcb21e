// See light_table.h.
#include "kinds/lights/light_table.h"

#include "geometry/light_tree.h"
#include "kinds/lights/light_kinds.h"
#include "scene/model/bounds.h"

#include "shaders/shared/limits.h"

#include <cmath>
#include <numbers>
#include <numeric>

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
    shares.push_back(share);
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
    const std::vector<double> pmf = photonPmf(table.weights, table.shares);
    double sum = 0;
    for (std::size_t i = 0; i < pmf.size(); ++i) {
        sum += pmf[i];
        table.lights[i].pmf = static_cast<float>(pmf[i]);
        table.lights[i].cdf = static_cast<float>(sum);
    }
    if (!table.lights.empty()) {
        table.lights.back().cdf = 1;
    }
}

shared::LightNode nodeRecord(const LightTree::Node& node) {
    const LightExtent& e = node.extent;
    return {.center = e.center,
            .radius = static_cast<float>(e.radius),
            .axis = e.axis,
            .cosSpread = static_cast<float>(std::cos(e.spread)),
            .sinSpread = static_cast<float>(std::sin(e.spread)),
            .cosFade = static_cast<float>(std::cos(e.fade)),
            .intensity = static_cast<float>(e.intensity),
            .parent = node.parent,
            .second = node.second,
            .light = node.light};
}

void addNodes(const Scene& scene, LightTable& table) {
    const LightTree tree = buildLightTree(lightExtents(scene));
    table.nodes = nodeRecords(tree);
    table.farCount = tree.farCount;
    placeInTree(table.lights, tree);
}

} // namespace

std::vector<double> photonPmf(const std::vector<double>& weights, const std::vector<double>& shares) {
    const double flux = std::accumulate(weights.begin(), weights.end(), 0.0);
    const double all = std::accumulate(shares.begin(), shares.end(), 0.0);
    constexpr double kEven = shared::kEvenPhotons;
    std::vector<double> pmf;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        pmf.push_back((1 - kEven) * weights[i] / flux + kEven * shares.at(i) / all);
    }
    return pmf;
}

std::vector<shared::LightNode> nodeRecords(const LightTree& tree) {
    std::vector<shared::LightNode> records;
    for (const LightTree::Node& node : tree.nodes) {
        records.push_back(nodeRecord(node));
    }
    return records;
}

void placeInTree(std::vector<shared::LightRecord>& lights, const LightTree& tree) {
    for (std::size_t i = 0; i < lights.size(); ++i) {
        lights[i].node = tree.leafOf.at(i);
        lights[i].isFar = lights[i].node < tree.farCount ? 1 : 0;
        lights[i].extent = nodeRecord(tree.nodes.at(lights[i].node));
    }
}

LightTable buildLightTable(const Scene& scene) {
    LightTable table;
    for (const LightKind* kind : kLightKinds) {
        if (kind->addRecords != nullptr) {
            kind->addRecords(scene, table);
        }
    }
    setProbabilities(table);
    addNodes(scene, table);
    return table;
}

void setAddresses(std::vector<shared::LightRecord>& lights, shared::LightTriangleArray triangles,
                  shared::RadianceArray texels, shared::CdfArray cdfs, shared::LightHierarchyArray hierarchy) {
    for (shared::LightRecord& light : lights) {
        light.triangles.address += triangles.address;
        light.texels.address += texels.address;
        light.cdfs.address += cdfs.address;
        light.hierarchy = hierarchy;
    }
}

} // namespace hyalite::kinds
