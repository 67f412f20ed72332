// Froxels: cells of the picture times slices of depth, which thicken exponentially from the eye on.
// Wronski 2014, Volumetric Fog; effects/volumetric-fog/froxels.ts
uniform highp ivec4 farol_fogGrid; // xyz: number of froxels across, up and in depth; w: first slice of the draw
uniform highp vec2 farol_fogSlices; // scale (m) and exponent of the slices
uniform highp vec4 farol_fogRay; // projection: xy 1 / scale, zw shift

// depth (m) at a fractional slice, 0 to the number of slices
float farol_fogDepth(const in float slice) {
  return farol_fogSlices.x * (exp(farol_fogSlices.y * slice / float(farol_fogGrid.z)) - 1.0);
}

// view-space ray of depth 1 to a point of the picture (0 to 1)
vec3 farol_fogRayAt(const in vec2 place) {
  return vec3((place * 2.0 - 1.0 + farol_fogRay.zw) * farol_fogRay.xy, -1.0);
}
