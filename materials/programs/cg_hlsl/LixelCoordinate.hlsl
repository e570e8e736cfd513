// A position's coordinate in a shadow map, by the map's rows: (u w, v w, w, depth).
// Given a derivative instead, returns the coordinate's derivative.
float4 lixelCoordinate(float4 rowU, float4 rowV, float4 rowW, float4 rowDepth, float4 ws)
{
    return float4(dot(rowU, ws), dot(rowV, ws), dot(rowW, ws), dot(rowDepth, ws));
}
