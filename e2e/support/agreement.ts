import { type Difference, figuresOf } from './images';
import { recordComparison } from './comparison';
import { expect } from './test';

/** How far a technique's picture may be from stock three's; a limit that is left out is not checked. */
export interface Limits {
  /** Largest linear difference of a channel, at most. */
  readonly largest?: number;
  /** Signal to noise, at least (dB). */
  readonly psnr?: number;
  /** Share of pixels off by more than 2/255, at most. */
  readonly share?: number;
  /** Largest difference of alpha, at most. */
  readonly alpha?: number;
}

/** Largest difference of alpha: no buffer of a technique rounds alpha, so it is three's. */
const ALPHA = 1e-4;

/**
 * Every technique draws every lit material of three, on every kind of mesh, as stock three does, in linear float.
 *
 * Forward techniques run three's own shader: what is left is rounding. Techniques that keep the surface in a G-buffer
 * round albedo, roughness and metalness to 8 bits, normals to half floats, and add light in half floats; positions are
 * rebuilt, so that the pixels at a hard edge of light may fall on its other side. Inferred lighting computes light at a
 * quarter of the pixels: what changes from pixel to pixel (normal maps of noise, small highlights, edges of light) is
 * smoothed; measured 35.8 to 41.8 dB and 5 to 10% of pixels, 31 dB and 12% with hard edges.
 */
const FORWARD: Limits = { largest: 1e-4 };
const DEFERRED: Limits = { psnr: 60, share: 0.001 };
const limits: Record<string, Limits | undefined> = {
  forward: FORWARD,
  'forward-single-pass': FORWARD,
  'tiled-forward': FORWARD,
  'forward-plus': FORWARD,
  'clustered-forward': FORWARD,
  inferred: { psnr: 35, share: 0.12 },
};
/** Limits for lights with a hard edge: a pixel may lie on its other side where positions are rebuilt. */
const hardEdges: Record<string, Limits | undefined> = {
  inferred: { psnr: 30, share: 0.14 },
};

/** The limits of a technique for lights with a hard edge. */
export function hardEdgeLimits(technique: string): Limits {
  return hardEdges[technique] ?? (limits[technique] === FORWARD ? FORWARD : { psnr: 0, share: 0.001 });
}

/** From here on (dB) a difference is rounding: limits are measured on the software rasteriser, and GPUs round otherwise. */
const ROUNDING = process.env.FAROL_GPU ? 72 : 90;

/** Fails where a picture is more than 2 dB farther off than was measured. */
export function expectAsMeasured(psnr: number, measured: number, name: string): void {
  const said = `${name}: ${psnr.toFixed(1)} dB, measured ${measured}`;
  expect.soft(psnr, said).toBeGreaterThanOrEqual(Math.min(measured, ROUNDING) - 2);
}

/** Fails unless a technique's picture is as near to stock three's as its family is to be. */
export function checkAgreement(technique: string, difference: Difference, name: string, exception: Limits = {}): void {
  const { largest, psnr, share, alpha } = difference;
  const seen = `${name}, ${technique}: ${figuresOf(difference)}`;
  const limit = limits[technique] ?? DEFERRED;
  const asked = { largest: Infinity, psnr: 0, share: 1, alpha: ALPHA, ...limit, ...exception };
  const good = largest <= asked.largest && psnr >= asked.psnr && share <= asked.share && alpha <= asked.alpha;
  recordComparison({ suite: 'scenes', technique, name, good, ...difference });
  expect.soft(largest, seen).toBeLessThanOrEqual(asked.largest);
  expect.soft(psnr, seen).toBeGreaterThanOrEqual(asked.psnr);
  expect.soft(share, seen).toBeLessThanOrEqual(asked.share);
  expect.soft(alpha, seen).toBeLessThanOrEqual(asked.alpha);
}
