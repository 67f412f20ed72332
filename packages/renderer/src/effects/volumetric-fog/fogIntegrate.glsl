// Sums each column of froxels: scattered light and transmittance from the eye to the end of each slice.
// Hillaire 2015, Physically Based and Unified Volumetric Rendering in Frostbite (integral of a slice)
#include "fogSlices"
uniform highp sampler3D farol_froxels;
layout(location = 0) out highp vec4 farol_froxel0;
layout(location = 1) out highp vec4 farol_froxel1;
layout(location = 2) out highp vec4 farol_froxel2;
layout(location = 3) out highp vec4 farol_froxel3;
#if FAROL_FOG_LAYERS > 4
layout(location = 4) out highp vec4 farol_froxel4;
layout(location = 5) out highp vec4 farol_froxel5;
layout(location = 6) out highp vec4 farol_froxel6;
layout(location = 7) out highp vec4 farol_froxel7;
#endif
float farol_fogLength; // length of the ray for a depth of 1 m (m)
vec4 farol_fogSum = vec4(0.0, 0.0, 0.0, 1.0);

vec4 farol_addSlice(const in int slice) {
  vec4 froxel = texelFetch(farol_froxels, ivec3(gl_FragCoord.xy, slice), 0);
  float thickness = (farol_fogDepth(float(slice + 1)) - farol_fogDepth(float(slice))) * farol_fogLength;
  float passes = exp(-froxel.a * thickness);
  float reach = froxel.a * thickness > 1e-3 ? (1.0 - passes) / froxel.a : thickness;
  farol_fogSum.rgb += farol_fogSum.a * reach * froxel.rgb;
  farol_fogSum.a *= passes;
  return farol_fogSum;
}
//# main
farol_fogLength = length(farol_fogRayAt(gl_FragCoord.xy / vec2(farol_fogGrid.xy)));
for (int slice = 0; slice < farol_fogGrid.w; slice++) farol_addSlice(slice);
farol_froxel0 = farol_addSlice(farol_fogGrid.w);
farol_froxel1 = farol_addSlice(farol_fogGrid.w + 1);
farol_froxel2 = farol_addSlice(farol_fogGrid.w + 2);
farol_froxel3 = farol_addSlice(farol_fogGrid.w + 3);
#if FAROL_FOG_LAYERS > 4
farol_froxel4 = farol_addSlice(farol_fogGrid.w + 4);
farol_froxel5 = farol_addSlice(farol_fogGrid.w + 5);
farol_froxel6 = farol_addSlice(farol_fogGrid.w + 6);
farol_froxel7 = farol_addSlice(farol_fogGrid.w + 7);
#endif
