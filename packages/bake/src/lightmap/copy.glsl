// Copies light, by defines: scaled, added to a sum, as a picture, or as the radiance that a surface reflects
// three.js
uniform highp sampler2D farol_light;
uniform highp sampler2D farol_albedo;
uniform highp sampler2D farol_positions;
layout(location = 0) out highp vec4 farol_copied;

float farol_luminance(const in vec3 colour) {
  return dot(colour, vec3(0.2126, 0.7152, 0.0722));
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 light = texelFetch(farol_light, texel, 0);
#ifdef REFLECT
  // radiance of a Lambertian surface
  vec3 arrived = max(light.rgb, 0.0);
  farol_copied = vec4(arrived * texelFetch(farol_albedo, texel, 0).rgb * 0.31830989, 0.0);
#ifdef SOURCES
  float sources = clamp(light.a / max(farol_luminance(arrived), 1e-12), 0.0, 1.0);
#ifdef SOURCES_ALONE
  farol_copied.rgb *= sources;
#else
  farol_copied.a = sources * farol_luminance(farol_copied.rgb);
#endif
#endif
#endif
#ifdef ADD
  farol_copied = light.a < 0.0 ? vec4(0.0) : vec4(light.rgb, 1.0);
#endif
#ifdef ADD_VARIANCE
  farol_copied = max(light, 0.0);
#endif
#ifdef LIMIT
  farol_copied = texelFetch(farol_positions, texel, 0).w > 0.0 ? max(light, 0.0) : vec4(0.0, 0.0, 0.0, -1.0);
#endif
#ifdef REST
  farol_copied = light.a > 0.0 ? vec4(light.rgb, 0.0) : vec4(0.0, 0.0, 0.0, -1.0);
#endif
#ifdef PICTURE
  farol_copied = vec4(light.rgb, 1.0);
#endif
}
