// How the pixel programs that OGRE's shader system makes read Lixel's shadow maps. libLixelRTSS has
// them include this, and generates the calls: once Lixel_Receiver; then for each light
// Lixel_FirstMap, a Lixel_NextMap for each of its other maps, and Lixel_Visibility.
//
// LIXEL_UNITS is how many texture units hold shadow maps, at least 1. Which maps of a light they
// hold changes with the frame and with the object: a light's maps begin at one unit, its first, and
// follow each other. Where there is none, the first unit is negative.

#define LIXEL_BILINEAR 1
// The uniforms of programs that read one map: these programs have others, and the check of
// materials would say that these are not bound.
#define shadowMap lixelNoMap
#define lixelSizeBias lixelNoSize
#include "LixelShadow.glsl"
#undef shadowMap
#undef lixelSizeBias

// A receiver's position in the world, and its screen derivatives. Called where the flow does not
// diverge.
void Lixel_Receiver(in vec3 wsPosition, out vec4 ws, out vec4 dx, out vec4 dy)
{
    ws = vec4(wsPosition, 1.0);
    dx = vec4(dFdx(wsPosition), 0.0);
    dy = vec4(dFdy(wsPosition), 0.0);
}

// A light's first map, which serves unless another does.
void Lixel_FirstMap(in vec4 ws, in vec4 rowU, in vec4 rowV, in vec4 rowW, in vec4 rowDepth,
                    in vec4 sizeBias, in vec4 rowShare, out vec4 u, out vec4 v, out vec4 w,
                    out vec4 depth, out vec4 size, out float greatest, out float serving)
{
    u = rowU;
    v = rowV;
    w = rowW;
    depth = rowDepth;
    size = sizeBias;
    greatest = dot(rowShare, ws);
    serving = 0.0;
}

// Takes another map where its function is greater than those of the maps before it.
void Lixel_NextMap(in vec4 ws, in float map, in vec4 rowU, in vec4 rowV, in vec4 rowW,
                   in vec4 rowDepth, in vec4 sizeBias, in vec4 rowShare, inout vec4 u, inout vec4 v,
                   inout vec4 w, inout vec4 depth, inout vec4 size, inout float greatest,
                   inout float serving)
{
    float share = dot(rowShare, ws);
    if (share > greatest) {
        u = rowU;
        v = rowV;
        w = rowW;
        depth = rowDepth;
        size = sizeBias;
        greatest = share;
        serving = map;
    }
}

// A position's coordinate in the map that serves; of its derivatives, the coordinate's.
vec4 Lixel_Coordinate(vec4 u, vec4 v, vec4 w, vec4 depth, vec4 ws)
{
    return vec4(dot(u, ws), dot(v, ws), dot(w, ws), dot(depth, ws));
}

#define LIXEL_LOOK_IN(map) lixelVisibilityIn(map, size, coordinate, coordinateDx, coordinateDy)

// How much of a light there is: 1 where it is lit, 0 where it is in shadow.
void Lixel_Visibility(in vec4 ws, in vec4 dx, in vec4 dy, in vec4 u, in vec4 v, in vec4 w,
                      in vec4 depth, in vec4 size, in float firstUnit, in float serving,
                      in sampler2D map0,
#if LIXEL_UNITS > 1
                      in sampler2D map1,
#endif
#if LIXEL_UNITS > 2
                      in sampler2D map2,
#endif
#if LIXEL_UNITS > 3
                      in sampler2D map3,
#endif
#if LIXEL_UNITS > 4
                      in sampler2D map4,
#endif
#if LIXEL_UNITS > 5
                      in sampler2D map5,
#endif
#if LIXEL_UNITS > 6
                      in sampler2D map6,
#endif
#if LIXEL_UNITS > 7
                      in sampler2D map7,
#endif
#if LIXEL_UNITS > 8
                      in sampler2D map8,
#endif
#if LIXEL_UNITS > 9
                      in sampler2D map9,
#endif
#if LIXEL_UNITS > 10
                      in sampler2D map10,
#endif
#if LIXEL_UNITS > 11
                      in sampler2D map11,
#endif
#if LIXEL_UNITS > 12
                      in sampler2D map12,
#endif
#if LIXEL_UNITS > 13
                      in sampler2D map13,
#endif
#if LIXEL_UNITS > 14
                      in sampler2D map14,
#endif
#if LIXEL_UNITS > 15
                      in sampler2D map15,
#endif
                      out float visibility)
{
    vec4 coordinate = Lixel_Coordinate(u, v, w, depth, ws);
    vec4 coordinateDx = Lixel_Coordinate(u, v, w, depth, dx);
    vec4 coordinateDy = Lixel_Coordinate(u, v, w, depth, dy);
    int unit = firstUnit < 0.0 ? -1 : int(firstUnit + serving + 0.5);
    visibility = 1.0;
    if (unit == 0)
        visibility = LIXEL_LOOK_IN(map0);
#if LIXEL_UNITS > 1
    if (unit == 1)
        visibility = LIXEL_LOOK_IN(map1);
#endif
#if LIXEL_UNITS > 2
    if (unit == 2)
        visibility = LIXEL_LOOK_IN(map2);
#endif
#if LIXEL_UNITS > 3
    if (unit == 3)
        visibility = LIXEL_LOOK_IN(map3);
#endif
#if LIXEL_UNITS > 4
    if (unit == 4)
        visibility = LIXEL_LOOK_IN(map4);
#endif
#if LIXEL_UNITS > 5
    if (unit == 5)
        visibility = LIXEL_LOOK_IN(map5);
#endif
#if LIXEL_UNITS > 6
    if (unit == 6)
        visibility = LIXEL_LOOK_IN(map6);
#endif
#if LIXEL_UNITS > 7
    if (unit == 7)
        visibility = LIXEL_LOOK_IN(map7);
#endif
#if LIXEL_UNITS > 8
    if (unit == 8)
        visibility = LIXEL_LOOK_IN(map8);
#endif
#if LIXEL_UNITS > 9
    if (unit == 9)
        visibility = LIXEL_LOOK_IN(map9);
#endif
#if LIXEL_UNITS > 10
    if (unit == 10)
        visibility = LIXEL_LOOK_IN(map10);
#endif
#if LIXEL_UNITS > 11
    if (unit == 11)
        visibility = LIXEL_LOOK_IN(map11);
#endif
#if LIXEL_UNITS > 12
    if (unit == 12)
        visibility = LIXEL_LOOK_IN(map12);
#endif
#if LIXEL_UNITS > 13
    if (unit == 13)
        visibility = LIXEL_LOOK_IN(map13);
#endif
#if LIXEL_UNITS > 14
    if (unit == 14)
        visibility = LIXEL_LOOK_IN(map14);
#endif
#if LIXEL_UNITS > 15
    if (unit == 15)
        visibility = LIXEL_LOOK_IN(map15);
#endif
}
