#include "transport/optics.h"

#include <cmath>
#include <complex>

namespace hyalite::testing {

double fresnel(double cosine, double n1, double n2) {
    const double sine = n1 / n2 * std::sqrt(1 - cosine * cosine);
    if (sine >= 1) {
        return 1;
    }
    const double beyond = std::sqrt(1 - sine * sine);
    const double s = (n1 * cosine - n2 * beyond) / (n1 * cosine + n2 * beyond);
    const double p = (n2 * cosine - n1 * beyond) / (n2 * cosine + n1 * beyond);
    return (s * s + p * p) / 2;
}

double metalFresnel(double cosine, double eta, double k) {
    const std::complex<double> n(eta, k);
    const std::complex<double> beyond = std::sqrt(1.0 - (1 - cosine * cosine) / (n * n));
    const double s = std::norm((cosine - n * beyond) / (cosine + n * beyond));
    const double p = std::norm((n * cosine - beyond) / (n * cosine + beyond));
    return (s + p) / 2;
}

namespace {

// Layers so far: reflectance from either side, and transmittance, which both sides share.
struct Sum {
    double front = 0;
    double back = 0;
    double through = 1;

    void addFace(double reflectance) {
        const double between = 1 / (1 - back * reflectance);
        front += through * through * reflectance * between;
        back = reflectance + (1 - reflectance) * (1 - reflectance) * back * between;
        through *= (1 - reflectance) * between;
    }
    void addLayer(double transmittance) {
        back *= transmittance * transmittance;
        through *= transmittance;
    }
};

} // namespace

Stack addTouching(const std::vector<Slab>& layers, double angle) {
    Sum sum;
    double n = 1;
    const auto cosineIn = [angle](double index) { return std::sqrt(1 - std::pow(std::sin(angle) / index, 2)); };
    for (const Slab& layer : layers) {
        sum.addFace(fresnel(cosineIn(n), n, layer.index));
        sum.addLayer(std::exp(-layer.sigma * layer.thickness / cosineIn(layer.index)));
        n = layer.index;
    }
    sum.addFace(fresnel(cosineIn(n), n, 1));
    return {sum.front, sum.through};
}

Stack addSlabs(const std::vector<Slab>& slabs, double angle) {
    std::vector<Slab> layers;
    for (const Slab& slab : slabs) {
        layers.push_back(slab);
        layers.push_back({1, 0, 0});
    }
    layers.pop_back();
    return addTouching(layers, angle);
}

} // namespace hyalite::testing
