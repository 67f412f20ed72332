interface LightLoopTraits {
  /** Whether neighbouring pixels may loop over different lights, so that derivatives in the loop are undefined. */
  readonly perPixel: boolean;
  /** Whether few lights may be read from uniforms (fewLights.glsl) in place of the light table's texture. Default false. */
  readonly readsFew?: boolean;
}

/** The microshaders that define FAROL_FOR_EACH_LIGHT. */
export const lightLoops = {
  lightLoopNone: { perPixel: false },
  lightLoopOne: { perPixel: false },
  lightLoopAll: { perPixel: false, readsFew: true },
  lightLoopTiled: { perPixel: true },
  lightLoopClustered: { perPixel: true },
  lightLoopSlices: { perPixel: true },
  lightLoopField: { perPixel: true },
  lightLoopBuffer: { perPixel: false },
  lightLoopVertex: { perPixel: false, readsFew: true },
} as const satisfies Record<string, LightLoopTraits>;

export type LightLoop = keyof typeof lightLoops;
