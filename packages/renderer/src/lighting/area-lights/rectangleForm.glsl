// Form factor of a parallelogram, seen from the origin, as a vector: its length times its direction.
// Lambert 1760; Heitz et al. 2016, Real-Time Polygonal-Light Shading with Linearly Transformed Cosines
//? length(farol_rectangleForm(vec3(0, 0, 1), vec3(1, 0, 0), vec3(0, -1, 0)) - vec3(0, 0, 0.554127)) < 3e-5 == true
//? length(farol_rectangleForm(vec3(0, 0, 9), vec3(0, -0.1, 0), vec3(-0.1, 0, 0)) - vec3(0, 0, 0.000157)) < 1e-6 == true
//? farol_aboveHorizon(vec3(0.0, 0.0, 0.25)) == 0.25
//? farol_aboveHorizon(vec3(0.0, 0.0, -0.5)) == 0.0
//? farol_isBelowHorizon(vec3(0.0, 0.0, -3.0), vec3(1.0, 0.0, 0.0), vec3(0.0, 0.5, 0.0)) == false
//? farol_isBelowHorizon(vec3(9.0, 0.0, -4.0), vec3(1.0, 0.0, 0.0), vec3(0.0, 0.5, 0.0)) == true

// angle / (sin(angle) 2π) for each cosine, by three's rational polynomial
vec4 farol_edgeWeights(const in vec4 cosines) {
  vec4 y = abs(cosines);
  vec4 weights = (0.8543985 + (0.4965155 + 0.0145206 * y) * y) / (3.4175940 + (4.1616724 + y) * y);
  bvec4 isAcute = greaterThan(cosines, vec4(0.0));
  if (all(isAcute)) return weights;
  return mix(0.5 * inversesqrt(max(1.0 - cosines * cosines, 1e-7)) - weights, weights, isAcute);
}

// u, v: half edges; positive seen from the side opposite to cross(u, v)
vec3 farol_rectangleForm(const in vec3 centre, const in vec3 u, const in vec3 v) {
  vec3 right = centre + u;
  vec3 left = centre - u;
  vec3 a = right - v;
  vec3 b = left - v;
  vec3 c = left + v;
  vec3 d = right + v;
  vec4 inverse = inversesqrt(vec4(dot(a, a), dot(b, b), dot(c, c), dot(d, d)));
  vec4 inverses = inverse * inverse.yzwx;
  vec4 weights = inverses * farol_edgeWeights(inverses * vec4(dot(a, b), dot(b, c), dot(c, d), dot(d, a)));
  // weighted sum of the edges' cross products, which are sums of those of u, v and centre
  return 2.0 * ((weights.x - weights.z) * cross(u, centre) + (weights.y - weights.w) * cross(centre, v)
    - (weights.x + weights.y + weights.z + weights.w) * cross(u, v));
}

// approximate form factor above the horizon (z = 0): Hill and Heitz 2016, Real-Time Area Lighting: a Journey
// from Research to Production, p. 102
float farol_aboveHorizon(const in vec3 form) {
  float size = length(form);
  return max((size * size + form.z) / (size + 1.0), 0.0);
}

// true where farol_aboveHorizon is certainly 0: the middle is twice a bounding sphere's radius below the horizon
bool farol_isBelowHorizon(const in vec3 centre, const in vec3 u, const in vec3 v) {
  return centre.z < 0.0 && centre.z * centre.z > 8.0 * (dot(u, u) + dot(v, v));
}
