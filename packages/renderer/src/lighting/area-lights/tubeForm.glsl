// Form factor of a thin tube, seen from the origin, above the plane z = 0.
// Heitz and Hill 2017, Real-Time Line- and Disk-Light Shading with Linearly Transformed Cosines
//? farol_tubeForm(vec3(-1.0, 0.0, -1.0), vec3(1.0, 0.0, -0.5), 0.1) == 0.000000
//? farol_tubeForm(vec3(-1.0, 0.0, 1.0), vec3(1.0, 0.0, 1.0), 0.05) == 0.040915
//? farol_tubeForm(vec3(-2.0, 0.5, 0.3), vec3(1.0, 1.0, 2.0), 0.02) == 0.008910
//? farol_tubeForm(vec3(-1.0, 1.0, -0.5), vec3(1.0, 0.5, 1.5), 0.04) == 0.019618
//? farol_tubeForm(vec3(4.0, 5.0, 1.0), vec3(4.0, 5.0, 9.0), 0.1) == 0.003182

// factor on a tube's width by the transform m; centre, halfAxis: before the transform
float farol_tubeWidth(const in mat3 m, const in vec3 centre, const in vec3 halfAxis) {
  vec3 across = cross(centre - halfAxis, centre + halfAxis);
  float size = length(across);
  if (size < 1e-9) return 0.0; // a tube seen along its axis has no area
  // inverse transpose of m up to a factor, by cross products
  vec3 x = cross(m[1], m[2]);
  vec3 y = cross(m[2], m[0]);
  vec3 z = cross(m[0], m[1]);
  return abs(dot(m[0], x)) * size / length(mat3(x, y, z) * across);
}

float farol_tubeForm(const in vec3 start, const in vec3 end, const in float radius) {
  if (start.z <= 0.0 && end.z <= 0.0) return 0.0;
  vec3 a = start;
  vec3 b = end;
  if (a.z < 0.0) a = (a * b.z - b * a.z) / (b.z - a.z);
  if (b.z < 0.0) b = (b * a.z - a * b.z) / (a.z - b.z);
  vec3 along = b - a;
  if (dot(along, along) < 1e-12) return 0.0;
  along = normalize(along);
  float from = dot(a, along);
  float to = dot(b, along);
  vec3 foot = a - from * along;
  float d = max(length(foot), 1e-5);
  vec2 l = vec2(from, to);
  vec2 squared = d * d + l * l;
  vec2 p = l / (d * squared) + atan(l / d) / (d * d);
  vec2 t = l * l / (d * squared);
  float integral = (p.y - p.x) * foot.z + (t.y - t.x) * along.z;
  return clamp(radius * integral * 0.3183098862, 0.0, 1.0);
}
