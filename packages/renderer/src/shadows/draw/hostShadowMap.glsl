// Copies a light's region of the shadow atlas to `shadow.map`: depths, and colours as of MeshDepthMaterial.
// three.js r187, WebGLShadowMap and ShaderLib.depth
uniform highp sampler2D farol_hostMapAtlas;
uniform highp vec4 farol_hostMapRegion; // xy: corner (texels); zw: size of the region over the map's size
uniform bool farol_hasMoments; // whether the atlas holds mean and deviation of depths, which are copied unchanged
uniform highp float farol_hostMapFar; // depth in the host's map where there is no caster
layout(location = 0) out highp vec4 farol_hostMap;
//# main
ivec2 at = ivec2(gl_FragCoord.xy * farol_hostMapRegion.zw + farol_hostMapRegion.xy);
vec4 texel = texelFetch(farol_hostMapAtlas, at, 0);
farol_hostMap = farol_hasMoments ? texel : vec4(vec3(texel.r == farol_hostMapFar ? texel.r : 1.0 - texel.r), 1.0);
gl_FragDepth = texel.r;
