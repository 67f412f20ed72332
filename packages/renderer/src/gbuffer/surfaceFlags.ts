// The microshader surfaceFlags.glsl is made from these tables: gbufferChunks.test.ts.

/** Which of three's lighting models a surface is lit by: the low two bits of its flags. */
export const shadingModels = { unlit: 0, standard: 1, phong: 2, lambert: 3 } as const;
export type ShadingModel = keyof typeof shadingModels;

/** Flag bits above the shading model. Whether an object receives shadows its shader says; the others are the material's. */
export const surfaceFlags = { hasFog: 4, isToneMapped: 8, receivesShadows: 16, isDithered: 32 } as const;
