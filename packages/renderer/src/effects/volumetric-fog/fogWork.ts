import { fogQualities, type Froxels } from './froxels';

/** Work that fog may be for a device. */
export interface FogWork {
  /** Froxels where the host does not set them. */
  readonly froxels: Froxels;
  /** Most light sums of a frame: froxels times lights, as if each light reached each froxel. */
  readonly sums: number;
  /** Frames of a still scene, each drawn anew as a whole, after which its picture changes hardly. */
  readonly stillFrames: number;
  /** Frames after a change of lights in which the mean stays short, so that few of them leave nothing of the old light. */
  readonly forgets: number;
}

const full: FogWork = { froxels: fogQualities.medium, sums: Infinity, stillFrames: 64, forgets: 0 };
const lite: FogWork = { froxels: fogQualities.low, sums: 16e6, stillFrames: 32, forgets: 4 };
/** About 0.1 s a frame on two cores. */
const software: FogWork = { froxels: fogQualities.lowest, sums: 1.5e6, stillFrames: 8, forgets: 6 };

/**
 * @param isLite - whether the quality is 'lite'
 * @param isSoftware - whether the processor draws
 */
export function fogWork(isLite: boolean, isSoftware: boolean): FogWork {
  return isSoftware ? software : isLite ? lite : full;
}

/**
 * Frames in which each slice is lit once, so that a frame keeps to `sums`: 1, 2, 4 or 8, at most `layers`.
 * @param lights - lights that may reach froxels
 * @param layers - slices of a draw
 */
export function turnsOf([across, up, away]: Froxels, lights: number, sums: number, layers: number): number {
  let turns = 1;
  while (turns < layers && across * up * away * Math.max(1, lights) > sums * turns) turns *= 2;
  return turns;
}
