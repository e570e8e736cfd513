// How the pixel programs that OGRE's shader system makes read Lixel's shadow maps. libLixelRTSS has
// them include this, and generates the calls: once Lixel_Receiver; then for each light
// Lixel_FirstMap, a Lixel_NextMap for each of its other maps, Lixel_Coordinates, and a Lixel_Read
// for each texture unit that holds a shadow map.
//
// Which maps of a light the units hold changes with the frame and with the object: a light's maps
// begin at one unit, its first, and follow each other. Where there is none, the first unit is
// negative.

#define LIXEL_BILINEAR 1
#define LIXEL_MAPS 0
#include "LixelShadow.glsl"

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

// A receiver's coordinate in the map that serves it, with its screen derivatives, and the unit that
// holds the map. Until that unit is read, the light is visible.
void Lixel_Coordinates(in vec4 ws, in vec4 dx, in vec4 dy, in vec4 u, in vec4 v, in vec4 w,
                       in vec4 depth, in float firstUnit, in float serving, out vec4 coordinate,
                       out vec4 coordinateDx, out vec4 coordinateDy, out float unit,
                       out float visibility)
{
    coordinate = lixelCoordinate(u, v, w, depth, ws);
    coordinateDx = lixelCoordinate(u, v, w, depth, dx);
    coordinateDy = lixelCoordinate(u, v, w, depth, dy);
    unit = firstUnit < 0.0 ? -1.0 : firstUnit + serving;
    visibility = 1.0;
}

// How much of a light there is, if it is this unit's map that serves: 1 where it is lit, 0 where it
// is in shadow. One call for each unit: GLSL 3.30 cannot pick a sampler by a number that varies.
void Lixel_Read(in sampler2D map, in float mapUnit, in float unit, in vec4 size, in vec4 coordinate,
                in vec4 coordinateDx, in vec4 coordinateDy, inout float visibility)
{
    if (int(unit + 0.5) == int(mapUnit) && unit >= 0.0)
        visibility = lixelVisibilityIn(map, size, coordinate, coordinateDx, coordinateDy);
}
