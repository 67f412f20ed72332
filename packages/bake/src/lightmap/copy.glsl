// Copies light: times a factor, to a sum, as a picture or as light that has arrived
// three.js
uniform highp sampler2D farol_light;
uniform highp sampler2D farol_albedo;
layout(location = 0) out highp vec4 farol_copied;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 light = texelFetch(farol_light, texel, 0);
#ifdef REFLECT
  // radiance of a surface that reflects in all directions alike
  farol_copied = vec4(max(light.rgb, 0.0) * texelFetch(farol_albedo, texel, 0).rgb * 0.31830989, 1.0);
#endif
#ifdef ADD
  farol_copied = light.a < 0.0 ? vec4(0.0) : vec4(light.rgb, 1.0);
#endif
#ifdef REST
  farol_copied = light.a > 0.0 ? vec4(light.rgb, 0.0) : vec4(0.0, 0.0, 0.0, -1.0);
#endif
#ifdef PICTURE
  farol_copied = vec4(light.rgb, 1.0);
#endif
}
