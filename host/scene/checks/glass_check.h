// Dielectrics bound solids: a path that enters one is inside it until it leaves. Here meshes that are wound inward are
// turned, and surfaces that bound nothing are reported.
#pragma once

#include "scene/model/mesh_shells.h"
#include "scene/model/scene.h"

#include <map>
#include <vector>

namespace hyalite::checks {

// Whether surfaces of the material are to bound a solid: a dielectric, but neither thin nor of index 1 without
// absorption and priority.
[[nodiscard]] bool boundsSolid(const Material& material);

// The shells of each mesh, found when first asked for. Throw away when a mesh changes.
class Shells {
public:
    explicit Shells(const Scene& scene) : scene_(scene) {}
    [[nodiscard]] const std::vector<MeshShell>& of(std::size_t mesh);

private:
    const Scene& scene_;
    std::map<std::size_t, std::vector<MeshShell>> known_;
};

// Turns the faces of closed meshes of dielectrics that are wound inward, and warns; objects of other materials keep the
// mesh as it is. A closed shell is right wound inward where it is a cavity: in an odd number of other shells of its
// mesh, or in another dielectric. A transform that mirrors changes nothing: it keeps a mesh's inside.
void turnInsideOutGlass(Scene& scene);

// Warns of dielectric quads, disks, open shapes and open meshes, unless they close a space together with others of
// their material or with opaque surfaces: rays from behind them are tried, some of them through the open edges.
void findOpenGlass(Scene& scene);

// Warns of triangles back to back within a mesh that emits light or bounds a dielectric.
void findBackToBackFaces(Scene& scene);

} // namespace hyalite::checks
