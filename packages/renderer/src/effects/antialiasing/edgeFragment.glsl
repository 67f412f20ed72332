// what a material's shader does after its tests
#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
float farol_depth = gl_FragDepth;
#elif defined( USE_REVERSED_DEPTH_BUFFER )
float farol_depth = farol_edgeZW.x / farol_edgeZW.y;
#else
float farol_depth = 0.5 * farol_edgeZW.x / farol_edgeZW.y + 0.5;
#endif
float farol_fit = 0.005;
#if defined( FAROL_VERTEX_NORMAL ) && ! defined( FLAT_SHADED )
// round things look alike on both sides of an edge between two triangles
if (length(fwidth(vNormal)) > 1e-3) farol_fit = 0.2;
#endif
vec4 farol_seen;
float farol_shown;
if (farol_edgeColor(ivec2(gl_FragCoord.xy), farol_depth, vec2(dFdx(farol_depth), dFdy(farol_depth)), farol_fit, farol_reuse, farol_seen, farol_shown)) {
gl_FragColor = vec4(farol_seen.rgb, farol_seen.a + farol_shown);
return;
}
