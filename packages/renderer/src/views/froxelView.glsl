// Light in one slice of froxels: the radiance of endless fog like the froxel's.
// Wronski 2014, Volumetric Fog
uniform highp sampler3D farol_froxels; // rgb: light scattered to the eye (radiance a metre); a: extinction (1/m)
uniform highp vec4 farol_panel; // corner and size of the panel (pixels)
uniform int farol_slice;
//# main
ivec3 size = textureSize(farol_froxels, 0);
vec2 place = (gl_FragCoord.xy - farol_panel.xy) / farol_panel.zw;
vec4 froxel = texelFetch(farol_froxels, ivec3(place * vec2(size.xy), farol_slice), 0);
gl_FragColor = vec4(froxel.a > 0.0 ? froxel.rgb / froxel.a : vec3(0.0), 1.0);
#include <tonemapping_fragment>
#include <colorspace_fragment>
