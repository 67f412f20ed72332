// Two plain lights as uniforms, so that frames with no more lights need not write the light table's texture.
// Farol
#define FAROL_FEW_LIGHTS
// number of lights in these uniforms: 0, or all lights
uniform highp int farol_fewLights;
uniform highp vec4 farol_fewSphere0;
uniform highp vec4 farol_fewSphere1;
uniform highp vec4 farol_fewEmission0;
uniform highp vec4 farol_fewEmission1;
// no array and no branch: software rasterisers are slow at variable indices
#define farol_few(first, second, record) mix(second, first, bvec4(record == 0))
