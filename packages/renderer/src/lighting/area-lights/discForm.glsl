// Form factor of an ellipse, seen from the origin.
// Heitz and Hill 2017, Real-Time Line- and Disk-Light Shading with Linearly Transformed Cosines
//? farol_discForm(vec3(0.0, 0.0, 1.0), vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0)) == vec2(0.500000, 1.000000)
//? farol_discForm(vec3(0.0, 0.0, 2.0), vec3(2.0, 0.0, 0.0), vec3(0.0, 2.0, 0.0)) == vec2(0.500000, 1.000000)
//? farol_discForm(vec3(1.0, 0.5, 1.5), vec3(0.6, 0.0, 0.2), vec3(0.0, 0.4, 0.1)) == vec2(0.040852, 0.829990)
// these half diameters are not perpendicular, for which software rasterisers' trigonometry is less exact
//? distance(farol_discForm(vec3(-0.5, 2, 0.8), vec3(1, 0, 0), vec3(1, 0, 1)), vec2(0.147193, 0.339947)) < 2e-4 == true
//? farol_discForm(vec3(3.0, -4.0, 8.0), vec3(0.1, 0.05, 0.0), vec3(0.0, 0.3, 0.2)) == vec2(0.000417, 0.847921)
//? farol_discForm(vec3(0.2, 0.1, 0.4), vec3(3.0, 0.0, 0.1), vec3(0.0, 0.05, 0.0)) == vec2(0.117356, 0.969742)

// x³ + 3 b x² + 3 c x + d: its three real roots, the middle one second
// Blinn 2006, How to Solve a Cubic Equation, part 5
vec3 farol_cubicRoots(const in float b, const in float c, const in float d) {
  vec3 delta = vec3(c - b * b, d - b * c, b * d - c * c);
  float root = sqrt(max(4.0 * delta.x * delta.z - delta.y * delta.y, 0.0));
  float angle = atan(root, 2.0 * b * delta.x - delta.y) / 3.0;
  float scale = 2.0 * sqrt(max(-delta.x, 0.0));
  float first = scale * cos(angle);
  float third = scale * cos(angle + 2.0943951024);
  vec2 large = vec2((first + third > 2.0 * b ? first : third) - b, 1.0);
  angle = atan(d * root, d * delta.y - 2.0 * c * delta.z) / 3.0;
  scale = 2.0 * sqrt(max(-delta.z, 0.0));
  first = scale * cos(angle);
  third = scale * cos(angle + 2.0943951024);
  vec2 small = vec2(-d, (first + third < 2.0 * c ? first : third) + c);
  float e = large.y * small.y;
  float f = -large.x * small.y - large.y * small.x;
  float g = large.x * small.x;
  vec3 roots = vec3(small.x / small.y, (c * f - b * g) / (c * e - b * f), large.x / large.y);
  if (roots.x < roots.y && roots.x < roots.z) return roots.yxz;
  if (roots.z < roots.x && roots.z < roots.y) return roots.xzy;
  return roots;
}

// u, v: conjugate half diameters; returns x: form factor, y: z component of its direction
vec2 farol_discForm(const in vec3 centre, const in vec3 u, const in vec3 v) {
  float uu = dot(u, u);
  float vv = dot(v, v);
  float uv = dot(u, v);
  vec3 x = u;
  vec3 y = v;
  float a = 1.0 / uu;
  float b = 1.0 / vv;
  if (abs(uv) > 1e-4 * sqrt(uu * vv)) { // the ellipse's axes are eigenvectors of the disc's projection
    float trace = uu + vv;
    float determinant = sqrt(max(uu * vv - uv * uv, 0.0));
    float p = 0.5 * sqrt(max(trace - 2.0 * determinant, 0.0));
    float q = 0.5 * sqrt(trace + 2.0 * determinant);
    float largest = (p + q) * (p + q);
    float least = (p - q) * (p - q);
    bool isWide = uu > vv;
    vec3 longer = isWide ? u : v;
    vec3 other = isWide ? v : u;
    float longest = max(uu, vv);
    x = uv * longer + (largest - longest) * other;
    y = uv * longer + (least - longest) * other;
    a = 1.0 / largest;
    b = 1.0 / max(least, 1e-12);
  }
  x = normalize(x);
  y = normalize(y);
  vec3 z = cross(x, y);
  if (dot(centre, z) < 0.0) z = -z;
  float height = max(dot(z, centre), 1e-6);
  float x0 = dot(x, centre) / height;
  float y0 = dot(y, centre) / height;
  a *= height * height;
  b *= height * height;
  // eigenvalues of the cone over the ellipse
  vec3 roots = farol_cubicRoots((1.0 - a * (1.0 + x0 * x0) - b * (1.0 + y0 * y0)) / 3.0,
    (a * b * (1.0 + x0 * x0 + y0 * y0) - a - b) / 3.0, a * b);
  vec3 direction = normalize(mat3(x, y, z) * vec3(a * x0 / (a - roots.y), b * y0 / (b - roots.y), 1.0));
  vec2 size = sqrt(max(-roots.y / roots.zx, vec2(0.0)));
  float form = size.x * size.y * inversesqrt((1.0 + size.x * size.x) * (1.0 + size.y * size.y));
  return vec2(form, direction.z);
}
