// after a material's alpha test: takes the surface's colour from the picture, or lets the shader go on
#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
float farol_depth = gl_FragDepth;
#elif defined( USE_REVERSED_DEPTH_BUFFER )
float farol_depth = farol_edgeZW.x / farol_edgeZW.y;
#else
float farol_depth = 0.5 * farol_edgeZW.x / farol_edgeZW.y + 0.5;
#endif
float farol_fit = 0.005;
#if defined( FAROL_VERTEX_NORMAL ) && ! defined( FLAT_SHADED )
// smooth normals look alike on both sides of an edge between two triangles: accepts a larger difference of depth
if (length(fwidth(vNormal)) > 1e-3) farol_fit = 0.2;
#endif
vec2 farol_slope = vec2(dFdx(farol_depth), dFdy(farol_depth));
vec4 farol_seen;
bool farol_found = farol_edgeColor(ivec2(gl_FragCoord.xy), farol_depth, farol_slope, farol_fit, farol_reuse, farol_seen,
  farol_shown);
farol_keeps = farol_found || !farol_shades;
farol_kept = vec4(farol_seen.rgb, farol_seen.a + farol_shown);
if (!farol_keeps) {
  // a surface that nearer ones hide in all neighbouring pixels is not shaded: its colour does not matter
  farol_keeps = true;
  for (int y = -1; y <= 1; y++) for (int x = -1; x <= 1; x++) {
    ivec2 farol_at = clamp(ivec2(gl_FragCoord.xy) + ivec2(x, y), ivec2(0), ivec2(farol_frameSize) - 1);
    vec2 farol_off = vec2(farol_at) + 0.5 - gl_FragCoord.xy;
    float farol_behind = farol_depth + dot(farol_slope, farol_off) - texelFetch(farol_pictureDepth, farol_at, 0).r;
#ifdef USE_REVERSED_DEPTH_BUFFER
    farol_behind = -farol_behind;
#endif
    farol_keeps = farol_keeps && farol_behind > 4.0 * FAROL_ROUNDING + abs(farol_slope.x) + abs(farol_slope.y);
  }
  farol_kept = farol_seen;
}
// shading uses derivatives, which are defined only if all four pixels of a quad branch alike; the first fwidth reaches
// the adjacent pixels, the second the diagonal one
float farol_quadShades = farol_keeps ? 0.0 : 1.0;
farol_quadShades += fwidth(farol_quadShades);
farol_quadShades += fwidth(farol_quadShades);
if (farol_quadShades == 0.0) {
gl_FragColor = farol_kept;
return;
}
