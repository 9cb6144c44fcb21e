// Measures the cost of large meshes: `measure_meshes TRIANGLES FILE.ply` writes a bumpy sphere of about that number of
// triangles as a binary PLY file, then reads it, tests if it is closed, bounds it and builds its hierarchy, printing
// for each step the seconds and the peak memory so far.
#include "base/stopwatch.h"
#include "geometry/bounding_sphere.h"
#include "geometry/bvh.h"
#include "scene/import/mesh_import.h"
#include "scene/model/mesh_topology.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <numbers>
#include <string>
#include <sys/resource.h>

namespace {

using namespace hyalite;

constexpr std::uint32_t kTrianglesPerLeaf = 4; // as the renderer has it

template <class T>
void put(std::ofstream& stream, T value) { // little endian, like every machine this is measured on
    stream.write(reinterpret_cast<const char*>(&value), sizeof value);
}

glm::vec3 bumpyPoint(double theta, double phi) {
    const double radius = 1 + 0.05 * std::sin(40 * theta) * std::sin(40 * phi);
    return {radius * std::sin(theta) * std::cos(phi), radius * std::cos(theta),
            radius * std::sin(theta) * std::sin(phi)};
}

// Rings of quads between two poles, 2 * rings * sectors triangles, with normals on request.
void writeSphere(const std::string& file, std::size_t triangles, bool smooth) {
    const auto rings = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(triangles) / 4));
    const std::uint32_t sectors = 2 * rings;
    const std::uint32_t pole = (rings + 1) * sectors; // each pole is a ring of one place and its first vertex is used
    std::ofstream stream(file, std::ios::binary);
    stream << "ply\nformat binary_little_endian 1.0\nelement vertex " << pole
           << "\nproperty float x\nproperty float y\nproperty float z\n"
           << (smooth ? "property float nx\nproperty float ny\nproperty float nz\n" : "") << "element face "
           << 2 * std::size_t{rings} * sectors << "\nproperty list uchar int vertex_indices\nend_header\n";
    for (std::uint32_t ring = 0; ring <= rings; ++ring) {
        for (std::uint32_t sector = 0; sector < sectors; ++sector) {
            const glm::vec3 p = bumpyPoint(std::numbers::pi * ring / rings, 2 * std::numbers::pi * sector / sectors);
            put(stream, p);
            if (smooth) {
                put(stream, p);
            }
        }
    }
    const auto at = [&](std::uint32_t ring, std::uint32_t sector) {
        return ring == 0 ? 0 : (ring == rings ? rings * sectors : ring * sectors + sector % sectors);
    };
    for (std::uint32_t ring = 0; ring < rings; ++ring) {
        for (std::uint32_t sector = 0; sector < sectors; ++sector) {
            put(stream, std::uint8_t{3});
            put(stream, glm::uvec3(at(ring, sector), at(ring, sector + 1), at(ring + 1, sector + 1)));
            put(stream, std::uint8_t{3});
            put(stream, glm::uvec3(at(ring, sector), at(ring + 1, sector + 1), at(ring + 1, sector)));
        }
    }
}

double seconds(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

// Wall-clock seconds and CPU seconds of all cores; the latter are meaningful on a busy machine too.
void measure(const char* step, const std::function<void()>& work) {
    rusage before{};
    getrusage(RUSAGE_SELF, &before);
    const Stopwatch watch;
    work();
    rusage after{};
    getrusage(RUSAGE_SELF, &after);
    const double computed =
        seconds(after.ru_utime) - seconds(before.ru_utime) + seconds(after.ru_stime) - seconds(before.ru_stime);
    std::printf("%-18s %8.3f s, %8.3f s of cores, %8.1f MB at most so far\n", step, watch.seconds(), computed,
                static_cast<double>(after.ru_maxrss) / 1024);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fprintf(stderr, "usage: measure_meshes TRIANGLES FILE.ply [smooth]\n");
        return 2;
    }
    try {
        const std::string file = argv[2];
        measure("write", [&] { writeSphere(file, std::strtoull(argv[1], nullptr, 10), argc > 3); });
        Mesh mesh;
        measure("load", [&] { mesh = importMesh(file, {}); });
        std::printf("%zu triangles, %zu vertices\n", mesh.triangles.size(), mesh.positions.size());
        measure("closed?", [&] { std::printf("%s\n", findOpenEdge(mesh) ? "open" : "closed"); });
        measure("bounding sphere", [&] { std::printf("radius %.6f\n", boundingSphere(mesh.positions).radius); });
        std::vector<Aabb> boxes(mesh.triangles.size());
        measure("boxes", [&] {
            for (std::size_t i = 0; i < boxes.size(); ++i) {
                for (int corner = 0; corner < 3; ++corner) {
                    boxes[i].add(mesh.positions[mesh.triangles[i][corner]]);
                }
            }
        });
        BinaryBvh binary;
        measure("binary hierarchy", [&] { binary = buildBinaryBvh(boxes, SplitMethod::SurfaceArea); });
        Bvh packed;
        measure("packed hierarchy", [&] { packed = packBvh(binary, kTrianglesPerLeaf); });
        std::printf("%.1f MB of nodes, %u stack entries\n", static_cast<double>(packed.texels.size()) * 16 / 1048576,
                    packed.stackEntries);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
