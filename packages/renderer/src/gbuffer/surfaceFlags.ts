// Tables from which gbufferChunks.test.ts makes the microshader surfaceFlags.glsl.

/** three's lighting model of a surface, in the low two bits of its flags. */
export const shadingModels = { unlit: 0, standard: 1, phong: 2, lambert: 3 } as const;
export type ShadingModel = keyof typeof shadingModels;

/**
 * Flag bits above the shading model. The shader adds the first, by the object, and the last two, by which
 * shadow maps are looked up along the vertices' normal; the others follow the material.
 */
export const surfaceFlags = {
  receivesShadows: 16,
  hasFog: 4,
  isToneMapped: 8,
  isDithered: 32,
  /** The G-buffer stores the vertices' normal too: it is not the shaded one. */
  hasVertexNormal: 64,
  /** The shaded normal is turned round: a back face's. */
  isReversed: 128,
} as const;
