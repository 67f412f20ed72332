// Slice of depth (with fraction) at a distance (m), in the light lists of fields.
// Farol
// x: where the first slice begins (m, or log2 of m); y: slices a unit of x; z: 1 if log2, else 0
uniform highp vec3 farol_fieldSlices;
float farol_slicePlace(const in float distanceVS) {
  float depth = farol_fieldSlices.z > 0.0 ? log2(max(distanceVS, 1e-6)) : distanceVS;
  return (depth - farol_fieldSlices.x) * farol_fieldSlices.y;
}
