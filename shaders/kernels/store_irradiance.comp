#version 460
#extension GL_GOOGLE_include_directive : require
// Turns the marked photons into irradiance records: the irradiance of their surface replaces the flux [Christensen99],
// and the radius of the disc that it was found in replaces the direction.
// reads: photons, irradiance, radii of the discs
// writes: irradiance records
// threads: photon slots
// computes: –
#include "shared/kernel_arguments.h"
#include "photons/photon.glsl"
#include "lib/thread.glsl"

layout(push_constant, scalar) uniform Push { StoreIrradianceArguments args; };

void main() {
    uint i = threadIndex();
    if (i >= args.count) {
        return;
    }
    Photon photon = args.photons.at[i];
    bool marked = photon.surface != kNone && (photon.direction & kMarkedPhoton) != 0u;
    photon.power = args.irradiance.at[i];
    photon.direction = packRecordRadius(args.radii.at[i]);
    photon.surface = marked ? photon.surface : kNone;
    args.records.at[i] = photon;
}
