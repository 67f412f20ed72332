// Copies a light's tile of the shadow atlas into a map of its own: depths, and colours as of three's MeshDepthMaterial.
// three.js r187, WebGLShadowMap and ShaderLib.depth
uniform highp sampler2D farol_shownAtlas;
uniform highp vec4 farol_shownTile; // corner (texels), texels of the tile a texel of the map
uniform highp float farol_shownFar; // depth where nothing is
layout(location = 0) out highp vec4 farol_shown;
//# main
vec4 texel = texelFetch(farol_shownAtlas, ivec2(gl_FragCoord.xy * farol_shownTile.zw + farol_shownTile.xy), 0);
#ifdef FAROL_MOMENTS
farol_shown = texel;
#else
farol_shown = vec4(vec3(texel.r == farol_shownFar ? texel.r : 1.0 - texel.r), 1.0);
gl_FragDepth = texel.r;
#endif
