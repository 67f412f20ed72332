// Shows a tile of an atlas in a panel: depths from near (black) to far (white), or colours.
// Farol
uniform highp sampler2D farol_atlas;
uniform highp vec4 farol_region; // corner and size of the tile in the atlas (texels)
uniform highp vec4 farol_panel; // corner and size of the panel (pixels)
uniform highp vec4 farol_depths; // xy: near and far (m); z: 1 in perspective; w: 1 if depth is reversed
uniform int farol_kind; // 0 nothing, 1 depths, 2 colours
//# main
vec2 place = gl_FragCoord.xy - farol_panel.xy;
vec4 value = texelFetch(farol_atlas, ivec2(farol_region.xy + place / farol_panel.zw * farol_region.zw), 0);
bool isEdge = any(lessThan(place, vec2(1.0))) || any(greaterThan(place, farol_panel.zw - 1.0));
if (farol_kind == 0) gl_FragColor = vec4(vec3(0.04), 1.0);
else if (isEdge) gl_FragColor = vec4(0.2, 0.3, 0.5, 1.0);
else if (farol_kind == 2) gl_FragColor = linearToOutputTexel(vec4(value.rgb, 1.0));
else {
  float depth = farol_depths.w > 0.0 ? 1.0 - value.r : value.r;
  float near = farol_depths.x;
  float far = farol_depths.y;
  if (farol_depths.z > 0.0) depth = log(far / (far - depth * (far - near))) / log(far / near);
  gl_FragColor = vec4(vec3(depth), 1.0);
}
