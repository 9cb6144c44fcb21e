// See light_table.h.
#include "render/upload/light_table.h"

#include "scene/model/bounds.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hyalite::render {

namespace {

using glm::dvec3;
using glm::vec3;
using std::numbers::pi;

double channelMean(const dvec3& c) {
    return (c.x + c.y + c.z) / 3;
}

// Appends the sums of the weights up to and including each, over the sum of all; evenly where all are 0. Returns that
// sum.
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
    cdfs.back() = 1; // not a rounding error less
    return total;
}

class LightTableBuilder {
public:
    explicit LightTableBuilder(const Scene& scene) : scene_(scene) {}

    LightTable build() {
        if (scene_.environment) {
            add(record(*scene_.environment), scene_.environment->photonShare);
        }
        addAll(scene_.lights);
        addAll(scene_.spots);
        addAll(scene_.directionals);
        table_.firstEmitter = static_cast<std::uint32_t>(table_.lights.size());
        for (const Object& object : scene_.objects) {
            if (object.emission != dvec3(0)) {
                add(record(object), object.photonShare);
            }
        }
        setProbabilities();
        return std::move(table_);
    }

private:
    template <class Light>
    void addAll(const std::vector<Light>& lights) {
        for (const Light& light : lights) {
            add(record(light), light.photonShare);
        }
    }

    void add(const shared::LightRecord& light, double share) {
        table_.lights.push_back(light);
        weights_.push_back(channelMean(light.power) * share);
    }

    void setProbabilities() {
        double total = 0;
        for (const double weight : weights_) {
            total += weight;
        }
        double sum = 0;
        for (std::size_t i = 0; i < weights_.size(); ++i) {
            sum += weights_[i];
            table_.lights[i].pmf = static_cast<float>(weights_[i] / total);
            table_.lights[i].cdf = static_cast<float>(sum / total);
        }
        if (!table_.lights.empty()) {
            table_.lights.back().cdf = 1;
        }
    }

    static shared::LightRecord record(const PointLight& light) {
        shared::LightRecord r{};
        r.type = shared::kLightPoint;
        r.position = light.position;
        r.emission = light.intensity;
        r.power = 4 * pi * light.intensity;
        return r;
    }

    static shared::LightRecord record(const SpotLight& light) {
        // 1 - cos = 2 sin^2 of half the angle
        const auto cone = [](double degrees) {
            const double sine = std::sin(degrees * pi / 360);
            return 2 * sine * sine;
        };
        const double inner = cone(light.angle * (1 - light.blend));
        const double outer = cone(light.angle);
        shared::LightRecord r{};
        r.type = shared::kLightSpot;
        r.position = light.position;
        r.normal = light.direction;
        r.cone = glm::dvec2(inner, outer);
        r.emission = light.intensity;
        r.power = pi * (inner + outer) * light.intensity; // see lights/spot.glsl
        return r;
    }

    [[nodiscard]] shared::LightRecord record(const DirectionalLight& light) const {
        shared::LightRecord r{};
        if (light.beam) {
            r.type = shared::kLightBeam;
            r.position = light.beam->center;
            setDisc(r, light.beam->radius, 0);
        } else {
            r = endless(shared::kLightDirectional);
        }
        r.normal = light.direction;
        r.emission = light.irradiance;
        r.power = double{r.area} * light.irradiance;
        return r;
    }

    [[nodiscard]] shared::LightRecord endless(std::uint32_t type) const {
        const LightSphere sphere = lightSphere(scene_);
        shared::LightRecord r{};
        r.type = type;
        r.position = sphere.center;
        setDisc(r, sphere.radius, sphere.distance);
        return r;
    }

    static void setDisc(shared::LightRecord& r, double radius, double distance) {
        r.radius = static_cast<float>(radius);
        r.distance = static_cast<float>(distance);
        r.area = static_cast<float>(pi * radius * radius);
    }

    [[nodiscard]] shared::LightRecord record(const Environment& environment) {
        const Image& image = environment.image;
        shared::LightRecord r = endless(shared::kLightEnvironment);
        r.columns = static_cast<std::uint32_t>(image.width);
        r.rows = static_cast<std::uint32_t>(image.height);
        const double turns = environment.rotation / 360;
        r.rotation = static_cast<float>(turns - std::floor(turns));
        r.rotation = r.rotation < 1 ? r.rotation : 0;
        r.cdfs.address = table_.cdfs.size() * sizeof(float);
        r.texels.address = table_.texels.size() * sizeof(vec3);

        // A row's texels have the solid angle 2 pi / columns times the difference of the cosines at its edges
        dvec3 integral(0);
        std::vector<double> rowWeights;
        std::vector<float> columnCdfs;
        for (int y = 0; y < image.height; ++y) {
            const double top = pi * y / image.height;
            const double bottom = pi * (y + 1) / image.height;
            const double band = 2 * std::sin((bottom - top) / 2) * std::sin((bottom + top) / 2);
            std::vector<double> weights;
            for (int x = 0; x < image.width; ++x) {
                const dvec3 radiance = dvec3(image.at(x, y)) * environment.scale;
                table_.texels.emplace_back(radiance);
                weights.push_back(channelMean(radiance));
                integral += radiance * (2 * pi / image.width * band);
            }
            rowWeights.push_back(appendCdf(columnCdfs, weights) * band);
        }
        appendCdf(table_.cdfs, rowWeights);
        table_.cdfs.insert(table_.cdfs.end(), columnCdfs.begin(), columnCdfs.end());
        r.emission = integral / (4 * pi);
        r.power = double{r.area} * integral;
        return r;
    }

    [[nodiscard]] shared::LightRecord record(const Object& object) {
        if (const auto* quad = std::get_if<Quad>(&object.shape)) {
            const dvec3 cross = glm::cross(quad->edge0, quad->edge1);
            return flat(shared::kLightQuad, quad->corner, quad->edge0, quad->edge1, glm::length(cross),
                        object.emission);
        }
        if (const auto* disk = std::get_if<Disk>(&object.shape)) {
            const dvec3 cross = glm::cross(disk->axis0, disk->axis1);
            return flat(shared::kLightDisk, disk->center, disk->axis0, disk->axis1, pi * glm::length(cross),
                        object.emission);
        }
        if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
            shared::LightRecord r =
                surface(shared::kLightSphere, 4 * pi * sphere->radius * sphere->radius, object.emission);
            r.position = sphere->center;
            r.radius = static_cast<float>(sphere->radius);
            return r;
        }
        if (const auto* instance = std::get_if<MeshInstance>(&object.shape)) {
            return record(*instance, object);
        }
        throw Error(ExitCode::BadInput, object.where, "only quads, disks, spheres and meshes emit light",
                    "give the emission to one of these");
    }

    static shared::LightRecord surface(std::uint32_t type, double area, const dvec3& radiance) {
        shared::LightRecord r{};
        r.type = type;
        r.area = static_cast<float>(area);
        r.emission = radiance;
        r.power = pi * area * radiance;
        return r;
    }

    static shared::LightRecord flat(std::uint32_t type, const dvec3& origin, const dvec3& edge0, const dvec3& edge1,
                                    double area, const dvec3& radiance) {
        shared::LightRecord r = surface(type, area, radiance);
        r.position = origin;
        r.edge0 = edge0;
        r.edge1 = edge1;
        r.normal = glm::normalize(glm::cross(edge0, edge1));
        return r;
    }

    [[nodiscard]] shared::LightRecord record(const MeshInstance& instance, const Object& object) {
        const Mesh& mesh = scene_.meshes[instance.mesh];
        const glm::dmat3 linear(instance.objectToWorld);
        const dvec3 translation(instance.objectToWorld[3]);
        const bool mirrored = glm::determinant(linear) < 0;
        const std::size_t first = table_.triangles.size();
        const std::size_t firstCdf = table_.cdfs.size();
        std::vector<double> areas;
        double reach = 0; // largest sum of the terms of a coordinate
        for (const glm::uvec3& triangle : mesh.triangles) {
            const dvec3 a(mesh.positions[triangle.x]);
            dvec3 edge0 = linear * (dvec3(mesh.positions[triangle.y]) - a);
            dvec3 edge1 = linear * (dvec3(mesh.positions[triangle.z]) - a);
            if (mirrored) {
                std::swap(edge0, edge1);
            }
            const dvec3 cross = glm::cross(edge0, edge1);
            const double twiceArea = glm::length(cross);
            if (!(twiceArea > 0)) {
                continue;
            }
            table_.triangles.push_back({linear * a + translation, edge0, edge1, cross / twiceArea});
            areas.push_back(twiceArea / 2);
            for (int corner = 0; corner < 3; ++corner) {
                const dvec3 p = glm::abs(dvec3(mesh.positions[triangle[corner]]));
                const dvec3 terms = glm::abs(linear[0]) * p.x + glm::abs(linear[1]) * p.y + glm::abs(linear[2]) * p.z +
                                    glm::abs(translation);
                reach = std::max({reach, terms.x, terms.y, terms.z});
            }
        }
        if (areas.empty() || table_.triangles.size() > shared::kLeafFirstMask) {
            throw Error(ExitCode::BadInput, object.where,
                        areas.empty() ? "this mesh has no area to emit light from"
                                      : "more than 134 million triangles in the scene's emitting meshes");
        }
        shared::LightRecord r = surface(shared::kLightMesh, appendCdf(table_.cdfs, areas), object.emission);
        r.columns = static_cast<std::uint32_t>(areas.size());
        r.error = static_cast<float>(0x1p-19 * reach); // as for hits of triangles, see shapes/surface.glsl
        r.triangles.address = first * sizeof(shared::LightTriangle);
        r.cdfs.address = firstCdf * sizeof(float);
        return r;
    }

    const Scene& scene_;
    LightTable table_;
    std::vector<double> weights_; // of the lights
};

} // namespace

LightTable buildLightTable(const Scene& scene) {
    return LightTableBuilder(scene).build();
}

void setAddresses(std::vector<shared::LightRecord>& lights, shared::LightTriangleArray triangles,
                  shared::RadianceArray texels, shared::CdfArray cdfs) {
    for (shared::LightRecord& light : lights) {
        light.triangles.address += triangles.address;
        light.texels.address += texels.address;
        light.cdfs.address += cdfs.address;
    }
}

} // namespace hyalite::render
