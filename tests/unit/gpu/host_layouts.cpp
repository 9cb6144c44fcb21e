// One line a struct, members by name. offsetof needs the name as a token: hence the macros, here and nowhere else.
#include "unit/gpu/host_layouts.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/self_test.h"
#include "shaders/shared/try_lights_arguments.h"

#include <cstddef>
#include <utility>

// Applies HOST_MEMBER to each name: rescanning the parentheses 4 * 4 * 4 times allows as many members.
#define HOST_RESCAN(...) HOST_RESCAN_16(HOST_RESCAN_16(HOST_RESCAN_16(HOST_RESCAN_16(__VA_ARGS__))))
#define HOST_RESCAN_16(...) HOST_RESCAN_4(HOST_RESCAN_4(HOST_RESCAN_4(HOST_RESCAN_4(__VA_ARGS__))))
#define HOST_RESCAN_4(...) HOST_RESCAN_1(HOST_RESCAN_1(HOST_RESCAN_1(HOST_RESCAN_1(__VA_ARGS__))))
#define HOST_RESCAN_1(...) __VA_ARGS__
#define HOST_PARENTHESES ()
#define HOST_MEMBERS(Struct, member, ...)                                                                              \
    HOST_MEMBER(Struct, member) __VA_OPT__(HOST_MEMBERS_AGAIN HOST_PARENTHESES(Struct, __VA_ARGS__))
#define HOST_MEMBERS_AGAIN() HOST_MEMBERS
#define HOST_MEMBER(Struct, member)                                                                                    \
    {.name = #member, .offset = offsetof(Struct, member), .size = sizeof(std::declval<Struct>().member)},
#define HOST_LAYOUT(Struct, ...)                                                                                       \
    layouts[#Struct] = {.size = sizeof(Struct), .members = {HOST_RESCAN(HOST_MEMBERS(Struct, __VA_ARGS__))}}

namespace hyalite::testing {

using namespace hyalite::shared; // the names below are the kernels'

std::map<std::string, HostLayout> hostLayouts() {
    std::map<std::string, HostLayout> layouts;
    HOST_LAYOUT(CameraRecord, position, forward, right, up, width, height, lensRadius, focusDistance, media);
    HOST_LAYOUT(MaterialRecord, type, color, eta, k, absorption, ior, roughness, metallic, coat, coatRoughness, coatIor,
                parameters, priority, thin, function, colorTexture, roughnessTexture);
    HOST_LAYOUT(LightTriangle, corner, edge0, edge1, normal);
    HOST_LAYOUT(LightRecord, type, position, edge0, edge1, normal, radius, distance, cone, error, area, emission, power,
                pmf, cdf, columns, rows, rotation, cdfs, triangles, texels, hierarchy, node, isFar, extent.center,
                extent.radius, extent.axis, extent.cosSpread, extent.sinSpread, extent.cosFade, extent.intensity,
                extent.parent, extent.second, extent.light, media);
    HOST_LAYOUT(LightNode, center, radius, axis, cosSpread, sinSpread, cosFade, intensity, parent, second, light);
    HOST_LAYOUT(LightHierarchy, nodes, lightCount, farCount);
    HOST_LAYOUT(InstanceRecord, row0, row1, row2, neighbors, neighborCount);
    HOST_LAYOUT(Ray, origin, tMax, direction, from);
    HOST_LAYOUT(Hit, t, object, primitive, uv);
    HOST_LAYOUT(CameraPath, beta, pixel, samplerSeed, media, pdfW);
    HOST_LAYOUT(VisiblePoint, position, depth, normal, samplerSeed, onSurface, from, wo, geometricNormal, beta, pixel,
                uv, material, probability, media);
    HOST_LAYOUT(RoughPoint, position, error, normal, depth, geometricNormal, samplerSeed, wo, from, beta, result, uv,
                material, isCoat, media, beyond);
    HOST_LAYOUT(PhotonPath, power, photon, light, kind, media);
    HOST_LAYOUT(Photon, position, direction, power, surface);
    HOST_LAYOUT(PhotonFate, stored, absorbed, escaped, cutOff);
    HOST_LAYOUT(GridRecord, inverseCellSize, bucketMask);
    HOST_LAYOUT(PhotonMapRecord, order, cellStarts, grid.inverseCellSize, grid.bucketMask, base, count);
    HOST_LAYOUT(RenderSeed, sequence);
    HOST_LAYOUT(GenerateCameraRaysArguments, rays, paths, seed.sequence, camera.position, camera.forward, camera.right,
                camera.up, camera.width, camera.height, camera.lensRadius, camera.focusDistance, camera.media, count,
                pass);
    HOST_LAYOUT(TraceClosestArguments, rays, hits, count, rootNode, width, live);
    HOST_LAYOUT(ShadeSurfaceArguments, rays, hits, paths, materials, lights, normals, instances, visiblePoints, emitted,
                nextRays, nextPaths, alive, count, depth, maxDepth, pass, roughPoints, width, live);
    HOST_LAYOUT(TraceWhittedArguments, slots, rays, paths, materials, lights, normals, instances, light, pixels,
                roughPoints, nextRays, nextPaths, alive, seed.sequence, camera.position, camera.forward, camera.right,
                camera.up, camera.width, camera.height, camera.lensRadius, camera.focusDistance, camera.media, count,
                depths, pass, minWeight, lightCount, rootNode, keptRays, keptPaths, hits, emitted, visiblePoints, live,
                rayCount);
    HOST_LAYOUT(SampleRoughLightsArguments, roughPoints, materials, lights, direct, count, light, pass, rootNode, live,
                rayCount, sought, normals, instances);
    HOST_LAYOUT(SampleLightsArguments, visiblePoints, materials, lights, shadowRays, contributions, count, light, pass,
                maxDepth, bounceDepth, width, live, paths, sought);
    HOST_LAYOUT(TryLightsArguments, visiblePoints, materials, lights, brought, tries, count, places, depth, pass,
                rootNode);
    HOST_LAYOUT(BouncePathsArguments, paths, visiblePoints, materials, nextRays, nextPaths, alive, count, depth,
                maxDepth, pass, live);
    HOST_LAYOUT(TraceShadowArguments, shadowRays, contributions, direct, count, rootNode, width, live, rayCount, paths,
                visiblePoints, materials, normals, instances);
    HOST_LAYOUT(EmitPhotonsArguments, lights, rays, paths, first, count, ofPass, lightCount, sequence);
    HOST_LAYOUT(ScatterPhotonArguments, rays, hits, paths, materials, normals, instances, photons, fates, nextRays,
                nextPaths, alive, count, firstPhoton, depth, maxDepth, sequence, kinds, account, room, live);
    HOST_LAYOUT(QueueSize, count, groupsX, groupsY, groupsZ, before);
    HOST_LAYOUT(CompactPathsArguments, alive, offsets, nextRays, nextPaths, rays, paths, count, live);
    HOST_LAYOUT(ScanGroupArguments, values, sums, count, live, queue, next, elementCount);
    HOST_LAYOUT(SumChunksArguments, values, sums, count, live);
    HOST_LAYOUT(ScanChunksArguments, values, chunkOffsets, sums, count, live);
    HOST_LAYOUT(ListNextRaysArguments, alive, chunkOffsets, slots, count, slotsOfPath, room, live);
    HOST_LAYOUT(CountCellsArguments, photons, cellCounts, ranks, grid.inverseCellSize, grid.bucketMask, count);
    HOST_LAYOUT(FillCellsArguments, photons, cellStarts, ranks, order, grid.inverseCellSize, grid.bucketMask, count);
    HOST_LAYOUT(OrderCellsArguments, cellStarts, order, count);
    HOST_LAYOUT(SortPhotonsArguments, photons, order, sorted, count);
    HOST_LAYOUT(MarkPhotonsArguments, photons, marks, count);
    HOST_LAYOUT(KeyedPhoton, key, photon);
    HOST_LAYOUT(KeyPhotonsArguments, photons, numbers, slots, keys, pairs, count, stored);
    HOST_LAYOUT(CountDigitsArguments, pairs, counts, count, stored, shift);
    HOST_LAYOUT(SortDigitsArguments, pairs, places, sorted, keys, lists, count, stored, shift, last);
    HOST_LAYOUT(SplitNodesArguments, lists, splits, nodes, count, level, stored);
    HOST_LAYOUT(CountSidesArguments, lists, splits, nodes, counts, count, level, chunks, stored);
    HOST_LAYOUT(PartSidesArguments, lists, splits, nodes, sums, parted, count, level, chunks, stored);
    HOST_LAYOUT(FinishSubtreesArguments, lists, others, nodes, count, level, stored);
    HOST_LAYOUT(PlacePhotonsArguments, photons, nodes, slots, sorted, order, count);
    HOST_LAYOUT(GatherRadianceArguments, visiblePoints, materials, cellStarts, gathered, grid.inverseCellSize,
                grid.bucketMask, radius, count, maxDepth, width, surfaceError);
    HOST_LAYOUT(NearestPhotonsArguments, visiblePoints, map.order, map.cellStarts, map.grid.inverseCellSize,
                map.grid.bucketMask, map.base, map.count, found, radius, nearest, kinds, count, maxDepth, surfaceError);
    HOST_LAYOUT(EstimateRadianceArguments, visiblePoints, materials, map.order, map.cellStarts,
                map.grid.inverseCellSize, map.grid.bucketMask, map.base, map.count, gathered, radii, radius,
                filterConstant, maxChange, nearest, kinds, filterKind, count, maxDepth, width, surfaceError, eye,
                footprint);
    HOST_LAYOUT(SumPathsArguments, pixels, light, radiance, count, live);
    HOST_LAYOUT(FilmSum, low, middle, high);
    HOST_LAYOUT(FilmColor, red.low, red.middle, red.high, green.low, green.middle, green.high, blue.low, blue.middle,
                blue.high);
    HOST_LAYOUT(AddGatheredLightArguments, colors, gathered, count, scale);
    HOST_LAYOUT(AccumulateFilmArguments, colors, film, faults, count);
    HOST_LAYOUT(ResolveFilmArguments, first, second, image, count, scale);
    HOST_LAYOUT(EstimateErrorArguments, first, second, sought, errors, sums, dark, count, firstPasses, secondPasses,
                layers, light);
    HOST_LAYOUT(ShowSurfaceArguments, rays, hits, normals, instances, colors, count, shown);
    HOST_LAYOUT(TargetRecord, center, radius);
    HOST_LAYOUT(EmitCausticPhotonsArguments, lights, targets, rays, paths, first, count, ofPass, lightCount,
                targetCount, sequence);
    HOST_LAYOUT(CastShadowPhotonsArguments, rays, hits, paths, materials, normals, instances, photons, nextRays,
                nextPaths, alive, count, firstPhoton, room, live);
    HOST_LAYOUT(StartGatherRaysArguments, visiblePoints, materials, rays, paths, alive, count, pass);
    HOST_LAYOUT(BeginIrradianceArguments, photons, visiblePoints, count);
    HOST_LAYOUT(StoreIrradianceArguments, photons, irradiance, radii, records, count);
    HOST_LAYOUT(LookUpIrradianceArguments, visiblePoints, materials, gathered, map.order, map.cellStarts,
                map.grid.inverseCellSize, map.grid.bucketMask, map.base, map.count, radius, scale, count, surfaceError);
    HOST_LAYOUT(ClassifyVisibilityArguments, visiblePoints, lit, shadowed, map.order, map.cellStarts,
                map.grid.inverseCellSize, map.grid.bucketMask, map.base, map.count, lightCount, nearest, agreeing,
                radius, count, surfaceError);
    HOST_LAYOUT(SkipShadowRaysArguments, lit, shadowed, shadowRays, contributions, direct, raysSaved, light, count);
    HOST_LAYOUT(SplatPhotonsArguments, photons, counts, camera.position, camera.forward, camera.right, camera.up,
                camera.width, camera.height, camera.lensRadius, camera.focusDistance, camera.media, count, rootNode);
    HOST_LAYOUT(SelfTestRecord, first, second, third, fourth);
    HOST_LAYOUT(SelfTestAnswer, rounds, texel, record.first, record.second, record.third, record.fourth);
    HOST_LAYOUT(SelfTestArguments, records, answers, rounds, count);
    return layouts;
}

} // namespace hyalite::testing
