import type { Material } from 'three';
import type { RenderItem } from './RenderItem';

/** A material whose draws are in the reactive mask: what it shows is not looked for in earlier frames. */
export type ReactiveMaterial = Material & { readonly isReactive?: boolean };

/** Where what changes without motion, such as particles, says which pixels it covers, once the frame is drawn. Frames are those of `Frame`. */
export interface ReactiveMask<Frame> {
  /** Draws an item with a material that writes its share of pixels to red, the greatest of which counts. */
  draw(frame: Frame, item: RenderItem, material: Material): void;
}
