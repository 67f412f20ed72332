// Tables from which gbufferChunks.test.ts makes the microshader surfaceFlags.glsl.

/** three's lighting model of a surface, in the low two bits of its flags. */
export const shadingModels = { unlit: 0, standard: 1, phong: 2, lambert: 3 } as const;
export type ShadingModel = keyof typeof shadingModels;

/**
 * Flag bits above the shading model. The shader sets the first, from the object, and the last two, for shadow look-ups along the
 * vertex normal; the others depend on the material.
 */
export const surfaceFlags = {
  receivesShadows: 16,
  hasFog: 4,
  isToneMapped: 8,
  isDithered: 32,
  /** Whether the G-buffer also stores the vertex normal, which differs from the shaded one. */
  hasVertexNormal: 64,
  /** Whether the shaded normal is reversed, on a back face. */
  isReversed: 128,
} as const;
