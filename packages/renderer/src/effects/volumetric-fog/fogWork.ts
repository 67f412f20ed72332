import { fogQualities, type Froxels } from './froxels';

/** Amount of work that fog may take on a device. */
export interface FogWork {
  /** Default numbers of froxels. */
  readonly froxels: Froxels;
  /** Maximum number of froxels times lights in a frame, as if each light reached each froxel. */
  readonly sums: number;
  /** Number of frames after which a still scene's picture hardly changes, if each frame computes all slices. */
  readonly stillFrames: number;
  /** Number of frames after a change of lights in which the mean stays short, so that old light vanishes soon. */
  readonly forgets: number;
}

const full: FogWork = { froxels: fogQualities.medium, sums: Infinity, stillFrames: 64, forgets: 0 };
const lite: FogWork = { froxels: fogQualities.low, sums: 16e6, stillFrames: 32, forgets: 4 };
/** For software rasterisers: about 0.1 s a frame on two cores. */
const software: FogWork = { froxels: fogQualities.lowest, sums: 1.5e6, stillFrames: 8, forgets: 6 };

/** @param isLite - whether the quality is 'lite' @param isSoftware - whether a software rasteriser draws */
export function fogWork(isLite: boolean, isSoftware: boolean): FogWork {
  return isSoftware ? software : isLite ? lite : full;
}

/**
 * Number of frames in which each slice is computed once, so that a frame stays within `sums`: 1, 2, 4 or 8, at most `layers`.
 * @param lights - number of lights that may reach froxels
 * @param layers - number of slices of a draw
 */
export function turnsOf([across, up, away]: Froxels, lights: number, sums: number, layers: number): number {
  let turns = 1;
  while (turns < layers && across * up * away * Math.max(1, lights) > sums * turns) turns *= 2;
  return turns;
}
