// Reads the attachments of the G-buffer, and its depth.
// Farol; made from the rows of gbuffer/gbufferLayout.ts by gbuffer/gbufferChunks.test.ts
uniform highp sampler2D farol_gAccumulation;
vec4 farol_gAccumulationAt(const in ivec2 pixel) { return texelFetch(farol_gAccumulation, pixel, 0); }
uniform highp sampler2D farol_gNormal;
vec4 farol_gNormalAt(const in ivec2 pixel) { return texelFetch(farol_gNormal, pixel, 0); }
uniform lowp sampler2D farol_gAlbedo;
vec4 farol_gAlbedoAt(const in ivec2 pixel) { return texelFetch(farol_gAlbedo, pixel, 0); }
uniform lowp sampler2D farol_gMaterial;
vec4 farol_gMaterialAt(const in ivec2 pixel) { return texelFetch(farol_gMaterial, pixel, 0); }
uniform highp sampler2D farol_gDepth;
float farol_gDepthAt(const in ivec2 pixel) { return texelFetch(farol_gDepth, pixel, 0).r; }
