// A number from 0 to 1 as a colour: black for 0, then blue, cyan, green, yellow, red.
// Farol
//? farol_heatMap(0.0) == vec3(0.0)
//? farol_heatMap(1.0) == vec3(1.0, 0.0, 0.0)
vec3 farol_heatMap(const in float heat) {
  if (heat <= 0.0) return vec3(0.0);
  float t = min(heat, 1.0) * 4.0;
  return clamp(vec3(t - 2.0, t < 3.0 ? t : 4.0 - t, 2.0 - t), 0.0, 1.0);
}
