// Least and greatest depth of a block of 8 × 8 texels of the shadow atlas, in 65,535ths: the least
// rounded down, the greatest up.
// Farol; depth bounds by block: Sintorn et al. 2011, Per-Triangle Shadow Volumes Using a View-Sample Cluster Hierarchy
uniform highp sampler2D farol_shadowDepths;
layout(location = 0) out highp uvec4 farol_bounds;
//# main
ivec2 first = ivec2(gl_FragCoord.xy) * 8;
ivec2 end = min(first + 8, textureSize(farol_shadowDepths, 0));
float least = 1.0;
float greatest = 0.0;
for (int y = first.y; y < end.y; y++) {
  for (int x = first.x; x < end.x; x++) {
    float depth = texelFetch(farol_shadowDepths, ivec2(x, y), 0).r;
    least = min(least, depth);
    greatest = max(greatest, depth);
  }
}
farol_bounds = uvec4(floor(least * 65535.0), ceil(greatest * 65535.0), 0u, 0u);
