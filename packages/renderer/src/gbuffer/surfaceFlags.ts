/** Which of three's lighting models a surface is lit by: the low two bits of its flags. */
export const shadingModels = { unlit: 0, standard: 1, phong: 2, lambert: 3 } as const;
export type ShadingModel = keyof typeof shadingModels;

/** Flag bits above the shading model. Whether an object receives shadows its shader says; the others are the material's. */
export const surfaceFlags = { hasFog: 4, isToneMapped: 8, receivesShadows: 16 } as const;

const flagOf = ([name, bit]: [string, number]) => `bool farol_${name}(int flags) { return (flags & ${bit}) != 0; }\n`;

/** The microshader `surfaceFlags`: the shading models that shaders tell apart, and what the flags of a surface say. */
export const surfaceFlagsChunk = `// The flags of a surface: its shading model, and what else is done with it.
// Farol; made from the tables in gbuffer/surfaceFlags.ts
const int FAROL_STANDARD = ${shadingModels.standard}, FAROL_PHONG = ${shadingModels.phong};
const int FAROL_RECEIVES_SHADOWS = ${surfaceFlags.receivesShadows};
int farol_shadingModel(int flags) { return flags & 3; }
float farol_packFlags(int flags) { return float(flags) / 255.0; }
int farol_unpackFlags(float stored) { return int(stored * 255.0 + 0.5); }
${Object.entries(surfaceFlags).map(flagOf).join('')}`;
