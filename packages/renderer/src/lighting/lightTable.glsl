// The light table: records of lights in runs, read by index.
// Farol; layout in lights/lightRecord.ts
#include "lightRecord"
// numbers of lights: x: directional; y: local, no range; z: local, with a range; w: those of z that are not plain
// point lights
uniform highp ivec4 farol_lightCounts;
