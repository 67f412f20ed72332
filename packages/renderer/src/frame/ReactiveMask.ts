import type { Material } from 'three';
import type { RenderItem } from './RenderItem';

/** A material whose draws are in the reactive mask: what it shows is not looked for in earlier frames. */
export type ReactiveMaterial = Material & { readonly isReactive?: boolean };

/** Mask of pixels that change without motion, such as those of particles; written after the frame is drawn. */
export interface ReactiveMask<Frame> {
  /** Draws an item with a material that writes its share of pixels to red, the greatest of which counts. */
  draw(frame: Frame, item: RenderItem, material: Material): void;
}
