import type { Data3DTexture, IUniform, Texture } from 'three';
import type { Frame } from './Frame';

/** Ambient occlusion of a frame. */
export interface OcclusionBuffer {
  /** Open share of the sky over each pixel, in red (0 to 1), filtered; drawn by this call if not yet drawn. */
  openSky(frame: Frame): Texture;
}

/** Motion of pixels since the last frame. */
export interface MotionBuffer {
  /** Uniforms of taaDepth.glsl, whose `farol_wayOf` returns motion, and `farol_hasPast`: false in the first frame. */
  readonly uniforms: Record<string, IUniform>;
  /** Mask of pixels whose history is not used, in red (0 to 1); null where there are none. */
  readonly reactive: Texture | null;
}

/** Fog froxels of a frame. */
export interface FroxelBuffer {
  /** For each froxel, light scattered to the eye per metre (linear radiance), and extinction (1/m). */
  readonly scattered: Data3DTexture | null;
  /** Number of froxels across, up and in depth. */
  readonly froxels: readonly [number, number, number];
  /** Depth (m) of a slice's edge, 0 (the eye) to the number of slices. */
  depthOf(edge: number): number;
}
