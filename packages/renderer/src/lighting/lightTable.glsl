// The light table: records of lights in runs, read by index.
// Farol; layout in lights/lightRecord.ts
#include "lightRecord"
// lights: x: directional; y: local without a range; z: local with a range; w: of those, all but plain point lights
uniform highp ivec4 farol_lightCounts;
