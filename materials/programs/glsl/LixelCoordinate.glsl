// A position's coordinate in a shadow map, by the map's rows: (u w, v w, w, depth).
// Given a derivative instead, returns the coordinate's derivative.
vec4 lixelCoordinate(vec4 rowU, vec4 rowV, vec4 rowW, vec4 rowDepth, vec4 ws)
{
    return vec4(dot(rowU, ws), dot(rowV, ws), dot(rowW, ws), dot(rowDepth, ws));
}
