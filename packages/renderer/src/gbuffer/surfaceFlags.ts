// The microshader surfaceFlags.glsl is made from these tables: gbufferChunks.test.ts.

/** three's lighting model of a surface, in the low two bits of its flags. */
export const shadingModels = { unlit: 0, standard: 1, phong: 2, lambert: 3 } as const;
export type ShadingModel = keyof typeof shadingModels;

/**
 * Flag bits above the shading model. The shader adds `receivesShadows`, by the object; the others follow the material.
 */
export const surfaceFlags = { hasFog: 4, isToneMapped: 8, receivesShadows: 16, isDithered: 32 } as const;
