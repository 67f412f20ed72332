// Where a distance lies in the slices of depth that light lists of fields have.
// Farol
uniform highp vec3 farol_fieldSlices; // least depth; slices a depth; 1: depths are logarithms (m)
float farol_slicePlace(const in float distanceVS) {
  float depth = farol_fieldSlices.z > 0.0 ? log2(max(distanceVS, 1e-6)) : distanceVS;
  return (depth - farol_fieldSlices.x) * farol_fieldSlices.y;
}
