// The parameters of a surface's BSDF: MaterialModel holds those of any model; the structs below it each build one
// model.
#pragma once

#include "scene/model/code_twin.h"
#include "shaders/shared/materials.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <string>

namespace hyalite {

// Custom GLSL code of a scene.
struct CustomCode {
    std::string function; // its name
    std::string file;     // its path
    int line = 1;         // of the function's definition
    std::string text;
    std::shared_ptr<const CodeTwin> twin = {}; // what the reference runs instead; null: no twin
    std::string twinRefused = {};              // file of a twin for this function but for different code; empty: none
};

// Same fields as the device's MaterialRecord, except `function` and the textures; the textures are in the Material.
struct MaterialModel : shared::MaterialFields<double, glm::dvec3, glm::dvec4> {
    std::shared_ptr<const CustomCode> code; // custom model only: its function

    MaterialModel() : MaterialModel(shared::kMaterialAbsorber) {}
    explicit MaterialModel(std::uint32_t model, const glm::dvec3& ofColor = glm::dvec3(0)) : MaterialFields{} {
        type = model;
        color = ofColor;
        ior = 1;
    }
};

struct Diffuse {
    glm::dvec3 albedo{0.5}; // [0, 1]

    operator MaterialModel() const { return MaterialModel(shared::kMaterialDiffuse, albedo); }
};
struct Mirror {
    glm::dvec3 reflectance{1}; // [0, 1]

    operator MaterialModel() const { return MaterialModel(shared::kMaterialMirror, reflectance); }
};
struct Dielectric {
    double ior = 1.5;           // inside over outside, > 0; with a priority, over vacuum
    double roughness = 0;       // [0, 1]
    glm::dvec3 absorption{0};   // coefficient inside [1/m]
    std::uint32_t priority = 0; // of its volume over others where they overlap; 0: none, it is nested in them
    bool thin = false;          // both faces of a pane at once

    operator MaterialModel() const {
        MaterialModel model(shared::kMaterialDielectric, glm::dvec3(1));
        model.ior = ior;
        model.roughness = roughness;
        model.absorption = absorption;
        model.priority = priority;
        model.thin = thin ? 1 : 0;
        return model;
    }
};
struct Conductor { // metal of complex refractive index eta + i k
    glm::dvec3 eta{1};
    glm::dvec3 k{0};
    double roughness = 0; // [0, 1]

    operator MaterialModel() const {
        MaterialModel model(shared::kMaterialConductor);
        model.eta = eta;
        model.k = k;
        model.roughness = roughness;
        return model;
    }
};
struct MetallicRoughness {     // glTF's model: a metal, a diffuse base under a coat, or a mixture of the two
    glm::dvec3 baseColor{0.8}; // [0, 1]: colour of the diffuse base, and what the metal reflects at normal incidence
    double metallic = 0;       // [0, 1]
    double roughness = 0.5;    // [0, 1]

    operator MaterialModel() const {
        MaterialModel model(shared::kMaterialMetallicRoughness, baseColor);
        model.metallic = metallic;
        model.roughness = roughness;
        return model;
    }
};
// A smooth or microfacet reflector; vec3 function(float cosine, vec4 parameters) gives the fraction of light reflected.
struct CustomReflectance {
    std::shared_ptr<const CustomCode> code;
    glm::dvec4 parameters{0};
    double roughness = 0; // [0, 1]

    operator MaterialModel() const {
        MaterialModel model(shared::kMaterialCustom);
        model.code = code;
        model.parameters = parameters;
        model.roughness = roughness;
        return model;
    }
};

} // namespace hyalite
