import type { Data3DTexture, IUniform, Texture } from 'three';
import type { Frame } from './Frame';

/** Ambient occlusion of a frame. */
export interface OcclusionBuffer {
  /** Share of the sky that is open over each pixel, in red (0 to 1), filtered; drawn when it is not there yet. */
  openSky(frame: Frame): Texture;
}

/** Motion of a frame's pixels since the last. */
export interface MotionBuffer {
  /** Uniforms of taaDepth.glsl, whose `farol_wayOf` tells motion, and `farol_hasPast`: false in the first frame. */
  readonly uniforms: Record<string, IUniform>;
  /** Pixels whose past is not used, in red (0 to 1); null where there are none. */
  readonly reactive: Texture | null;
}

/** Froxels of a frame. */
export interface FroxelBuffer {
  /** By froxel: light scattered to the eye a metre (linear radiance), and extinction (1/m). */
  readonly scattered: Data3DTexture | null;
  /** Froxels across, up and away. */
  readonly froxels: readonly [number, number, number];
  /** Depth (m) of a slice's edge, 0 (the eye) to the number of slices. */
  depthOf(edge: number): number;
}
