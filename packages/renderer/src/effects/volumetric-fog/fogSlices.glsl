// Froxels: cells of the picture by slices of depth that widen exponentially, from the eye on.
// Wronski 2014, Volumetric Fog; effects/volumetric-fog/froxels.ts
uniform highp ivec4 farol_fogGrid; // froxels across, up and away; first slice of the draw
uniform highp vec2 farol_fogSlices; // scale (m) and exponent of the slices
uniform highp vec4 farol_fogRay; // 1 / x and y scale of the projection, and its x and y shift

// depth (m) of a place among the slices, 0 to their number
float farol_fogDepth(const in float slice) {
  return farol_fogSlices.x * (exp(farol_fogSlices.y * slice / float(farol_fogGrid.z)) - 1.0);
}

// view-space ray to a place of the picture (0 to 1), of depth 1
vec3 farol_fogRayAt(const in vec2 place) {
  return vec3((place * 2.0 - 1.0 + farol_fogRay.zw) * farol_fogRay.xy, -1.0);
}
