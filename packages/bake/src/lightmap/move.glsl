// Texel positions with the offsets found by settle.glsl
// Gribble 2019, Baking artifact-free lightmaps
uniform highp sampler2D farol_places;
uniform highp sampler2D farol_moves;
layout(location = 0) out highp vec4 farol_settled;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 moved = texelFetch(farol_moves, texel, 0);
  farol_settled = vec4(texelFetch(farol_places, texel, 0).xyz + moved.xyz, moved.w);
}
