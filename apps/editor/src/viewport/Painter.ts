import type { Camera, Scene } from 'three';

/** Draws the picture in place of the technique alone: several views, or two techniques side by side. */
export interface Painter {
  /** Whether grid, icons and handles are drawn over it. */
  readonly drawsHelpers: boolean;
  /** Whether it is many pictures: what usually lies over one of them is away then. */
  readonly isGrid: boolean;
  /** Draws to the canvas, whose viewport is the whole picture before and after. */
  render(scene: Scene, camera: Camera): void;
  dispose(): void;
}
