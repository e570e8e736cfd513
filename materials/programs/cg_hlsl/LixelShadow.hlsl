// How a receiver reads a Lixel shadow map, in Cg and HLSL. Included by every receiver program.
//
// A map coordinate is (u w, v w, w, depth), affine in world space: u and v are texture coordinates,
// depth is what casters store. w <= 0 means that the light ray is not in the map.
//
// Define LIXEL_BILINEAR for percentage closer filtering over the 2x2 nearest texels; otherwise one
// nearest texel decides.
//
// Define LIXEL_MAPS as 2, 3, 4 or 6 for lights with as many maps: then lixelVisibilityAt takes a world
// position, and finds the map that serves it. Undefined, a light has one map, and lixelVisibility
// takes its coordinate. 0 is for programs with uniforms of their own, which call lixelVisibilityIn.
//
// A map's size and bias are (width, height, depth bias, depth per world unit).
#include "LixelCoordinate.hlsl"

// Steps of the grid that rasterizers move a vertex to, for one texel: GPUs and Mesa have 256.
#define LIXEL_SUBTEXELS 256.0

// Change of depth for one texel of u and v along the receiver's own surface (Isidoro 2006,
// "receiver plane depth bias"), from the coordinate's screen derivatives.
float2 lixelDepthSlope(float4 sizeBias, float4 coordinate, float4 dx, float4 dy)
{
    // d(u) = (d(u w) - u d(w)) / w
    float2 uv = coordinate.xy / coordinate.z;
    float2 tx = (dx.xy - uv * dx.z) / coordinate.z * sizeBias.xy;
    float2 ty = (dy.xy - uv * dy.z) / coordinate.z * sizeBias.xy;
    float determinant = tx.x * ty.y - tx.y * ty.x;
    float2 slope = float2(ty.y * dx.w - tx.y * dy.w, tx.x * dy.w - ty.x * dx.w) / determinant;
    // A surface seen exactly edge-on has no slope in the map.
    return determinant != 0.0 ? slope : float2(0.0, 0.0);
}

// 1 where the light reaches the receiver through this texel, else 0.
float lixelTap(sampler2D map, float4 sizeBias, float2 texel, float2 position, float depth, float2 slope)
{
    // The texel's centre: the unit's filter takes the nearest one, and clamps.
    float stored = tex2D(map, (texel + 0.5) / sizeBias.xy).r;
    // The receiver's surface where the light ray through the texel's centre meets it. A caster's
    // depth is at most 1: nothing is stored beyond the farthest receiver.
    float surface = depth + dot(slope, texel + 0.5 - position);
    // Rasterizers move vertices to a grid within texels, and a caster's depths with them.
    float rasterized = (abs(slope.x) + abs(slope.y)) / LIXEL_SUBTEXELS;
    return min(surface, 1.0) - sizeBias.z - rasterized <= stored ? 1.0 : 0.0;
}

// 1 where the receiver is lit, 0 where it is in shadow.
// dx, dy: the coordinate's screen derivatives
float lixelVisibilityIn(sampler2D map, float4 sizeBias, float4 coordinate, float4 dx, float4 dy)
{
    float2 uv = coordinate.xy / coordinate.z;
    if (!(coordinate.z > 0.0) || any(uv < 0.0) || any(uv > 1.0))
        return 1.0;
    float2 slope = lixelDepthSlope(sizeBias, coordinate, dx, dy);
    float2 position = uv * sizeBias.xy;
    float depth = coordinate.w;
#ifdef LIXEL_BILINEAR
    float2 corner = floor(position - 0.5);
    float2 weight = position - 0.5 - corner;
    float v00 = lixelTap(map, sizeBias, corner, position, depth, slope);
    float v10 = lixelTap(map, sizeBias, corner + float2(1.0, 0.0), position, depth, slope);
    float v01 = lixelTap(map, sizeBias, corner + float2(0.0, 1.0), position, depth, slope);
    float v11 = lixelTap(map, sizeBias, corner + float2(1.0, 1.0), position, depth, slope);
    return lerp(lerp(v00, v10, weight.x), lerp(v01, v11, weight.x), weight.y);
#else
    return lixelTap(map, sizeBias, floor(position), position, depth, slope);
#endif
}

#ifndef LIXEL_MAPS

uniform sampler2D shadowMap;
uniform float4 lixelSizeBias;

// Call it unconditionally: screen derivatives are undefined in divergent flow.
float lixelVisibility(float4 coordinate)
{
    return lixelVisibilityIn(shadowMap, lixelSizeBias, coordinate, ddx(coordinate),
                             ddy(coordinate));
}

#else
#if LIXEL_MAPS > 1

// There are no arrays of samplers with an index that varies, so each map has names of its own.
// Each map's names are in two lines: one compares its function with the others', one reads it.
#define LIXEL_COMPARE(map, rowShare) \
    share = dot(rowShare, ws); \
    if (share > greatest) { serving = map; greatest = share; }
#define LIXEL_READ(map, texels, sizeBias, u, v, w, depth) \
    if (serving == map) \
        return lixelVisibilityIn(texels, sizeBias, lixelCoordinate(u, v, w, depth, ws), \
                                 lixelCoordinate(u, v, w, depth, dx), \
                                 lixelCoordinate(u, v, w, depth, dy));

uniform sampler2D shadowMap0;
uniform float4 lixelRowU0, lixelRowV0, lixelRowW0, lixelRowDepth0, lixelSizeBias0, lixelRowShare0;
uniform sampler2D shadowMap1;
uniform float4 lixelRowU1, lixelRowV1, lixelRowW1, lixelRowDepth1, lixelSizeBias1, lixelRowShare1;
#define LIXEL_COMPARE_1 LIXEL_COMPARE(1, lixelRowShare1)
#define LIXEL_READ_1 LIXEL_READ(1, shadowMap1, lixelSizeBias1, lixelRowU1, lixelRowV1, \
                                lixelRowW1, lixelRowDepth1)
#if LIXEL_MAPS > 2
uniform sampler2D shadowMap2;
uniform float4 lixelRowU2, lixelRowV2, lixelRowW2, lixelRowDepth2, lixelSizeBias2, lixelRowShare2;
#define LIXEL_COMPARE_2 LIXEL_COMPARE(2, lixelRowShare2)
#define LIXEL_READ_2 LIXEL_READ(2, shadowMap2, lixelSizeBias2, lixelRowU2, lixelRowV2, \
                                lixelRowW2, lixelRowDepth2)
#else
#define LIXEL_COMPARE_2
#define LIXEL_READ_2
#endif
#if LIXEL_MAPS > 3
uniform sampler2D shadowMap3;
uniform float4 lixelRowU3, lixelRowV3, lixelRowW3, lixelRowDepth3, lixelSizeBias3, lixelRowShare3;
#define LIXEL_COMPARE_3 LIXEL_COMPARE(3, lixelRowShare3)
#define LIXEL_READ_3 LIXEL_READ(3, shadowMap3, lixelSizeBias3, lixelRowU3, lixelRowV3, \
                                lixelRowW3, lixelRowDepth3)
#else
#define LIXEL_COMPARE_3
#define LIXEL_READ_3
#endif
#if LIXEL_MAPS > 4
uniform sampler2D shadowMap4;
uniform float4 lixelRowU4, lixelRowV4, lixelRowW4, lixelRowDepth4, lixelSizeBias4, lixelRowShare4;
#define LIXEL_COMPARE_4 LIXEL_COMPARE(4, lixelRowShare4)
#define LIXEL_READ_4 LIXEL_READ(4, shadowMap4, lixelSizeBias4, lixelRowU4, lixelRowV4, \
                                lixelRowW4, lixelRowDepth4)
#else
#define LIXEL_COMPARE_4
#define LIXEL_READ_4
#endif
#if LIXEL_MAPS > 5
uniform sampler2D shadowMap5;
uniform float4 lixelRowU5, lixelRowV5, lixelRowW5, lixelRowDepth5, lixelSizeBias5, lixelRowShare5;
#define LIXEL_COMPARE_5 LIXEL_COMPARE(5, lixelRowShare5)
#define LIXEL_READ_5 LIXEL_READ(5, shadowMap5, lixelSizeBias5, lixelRowU5, lixelRowV5, \
                                lixelRowW5, lixelRowDepth5)
#else
#define LIXEL_COMPARE_5
#define LIXEL_READ_5
#endif

// The map whose function is greatest at a world position: the one that serves it.
int lixelServingMap(float4 ws)
{
    int serving = 0;
    float greatest = dot(lixelRowShare0, ws);
    float share;
    LIXEL_COMPARE_1
    LIXEL_COMPARE_2
    LIXEL_COMPARE_3
    LIXEL_COMPARE_4
    LIXEL_COMPARE_5
    return serving;
}

// 1 where the receiver is lit, 0 where it is in shadow. Call it unconditionally, as lixelVisibility.
float lixelVisibilityAt(float3 wsPosition)
{
    float4 ws = float4(wsPosition, 1.0);
    // Coordinates are affine in the position, so their derivatives come from its own, whichever
    // maps the neighbouring pixels read.
    float4 dx = float4(ddx(wsPosition), 0.0);
    float4 dy = float4(ddy(wsPosition), 0.0);
    int serving = lixelServingMap(ws);
    LIXEL_READ_5
    LIXEL_READ_4
    LIXEL_READ_3
    LIXEL_READ_2
    LIXEL_READ_1
    return lixelVisibilityIn(
        shadowMap0, lixelSizeBias0,
        lixelCoordinate(lixelRowU0, lixelRowV0, lixelRowW0, lixelRowDepth0, ws),
        lixelCoordinate(lixelRowU0, lixelRowV0, lixelRowW0, lixelRowDepth0, dx),
        lixelCoordinate(lixelRowU0, lixelRowV0, lixelRowW0, lixelRowDepth0, dy));
}

#endif
#endif
