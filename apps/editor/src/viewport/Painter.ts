import type { Camera, Scene } from 'three';

/** Replaces the viewport's normal rendering: several debug views, or two techniques side by side. */
export interface Painter {
  /** Whether grid, icons and handles are drawn over the painter's picture. */
  readonly drawsHelpers: boolean;
  /** Whether the painter shows many images in a grid; overlays such as the camera inset are then hidden. */
  readonly isGrid: boolean;
  /** Whether the picture shows illuminance in false colours, which have a scale. */
  readonly isIlluminance?: boolean;
  /** Renders to the canvas; the GL viewport must be the whole canvas before and after. */
  render(scene: Scene, camera: Camera): void;
  dispose(): void;
}
