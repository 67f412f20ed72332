/** What a technique cannot do of a scene's picture. */
export interface TechniqueLimits {
  /** It knows no depth before it shades: ambient occlusion is left out. */
  readonly occlusion: boolean;
  /** It shades a G-buffer, one sample a pixel: edges are smoothed by an effect or not at all. */
  readonly samples: boolean;
  /** It has no G-buffer: decals are not seen. */
  readonly decals: boolean;
}

const none: TechniqueLimits = { occlusion: false, samples: false, decals: false };
const forward: TechniqueLimits = { occlusion: true, samples: false, decals: true };
const deferred: TechniqueLimits = { occlusion: false, samples: true, decals: false };

const limits: Readonly<Record<string, TechniqueLimits>> = {
  forward,
  'forward-single-pass': forward,
  'tiled-forward': forward,
  'clustered-forward': forward,
  'forward-plus': { ...forward, occlusion: false },
  'light-prepass': { occlusion: false, samples: false, decals: true },
  inferred: { occlusion: true, samples: false, decals: true },
  deferred,
  'tiled-deferred': deferred,
  'clustered-deferred': deferred,
};

/** What a technique cannot do; nothing is known of those of plugins, and 'auto' picks one that can do what is asked for. */
export const techniqueLimits = (technique: string): TechniqueLimits =>
  Object.hasOwn(limits, technique) ? limits[technique] : none;
