// Slice of depth (with fraction) at a distance (m), in the light lists of fields.
// Farol
uniform highp vec3 farol_fieldSlices; // x: first slice's start (m, or log2 m); y: slices a unit; z: 1 if log2, else 0
float farol_slicePlace(const in float distanceVS) {
  float depth = farol_fieldSlices.z > 0.0 ? log2(max(distanceVS, 1e-6)) : distanceVS;
  return (depth - farol_fieldSlices.x) * farol_fieldSlices.y;
}
