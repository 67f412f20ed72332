// A vertex's position in the last frame, from the object's last matrices, bones, morphs and instances.
// Karis 2014, High Quality Temporal Supersampling; three's vertex chunks
// last frame's projection × view × world matrix, for a skinned mesh × inverse bind matrix
uniform highp mat4 farol_clipBefore;
uniform highp vec2 farol_jitter; // this frame's subpixel offset of the projection (normalised device coordinates)

mat4 farol_matrixOf(highp sampler2D matrices, const in int i) {
  int size = textureSize(matrices, 0).x;
  int j = i * 4;
  ivec2 at = ivec2(j % size, j / size);
  return mat4(texelFetch(matrices, at, 0), texelFetch(matrices, at + ivec2(1, 0), 0),
    texelFetch(matrices, at + ivec2(2, 0), 0), texelFetch(matrices, at + ivec2(3, 0), 0));
}
#ifdef USE_SKINNING
uniform highp sampler2D farol_bonesBefore;
#endif
#if defined( USE_INSTANCING ) || defined( USE_BATCHING )
uniform highp sampler2D farol_instancesBefore;
#endif
#if defined( USE_MORPHTARGETS ) && ! defined( USE_INSTANCING_MORPH )
uniform highp float farol_morphBaseBefore;
uniform highp float farol_morphsBefore[ MORPHTARGETS_COUNT ];
#endif
