import type { Material } from 'three';
import type { RenderItem } from './RenderItem';

/** A material whose pixels are in the reactive mask: temporal anti-aliasing ignores their history. */
export type ReactiveMaterial = Material & { readonly isReactive?: boolean };

/** Mask of pixels that change without motion, such as those of particles; written after the frame is drawn. */
export interface ReactiveMask<Frame> {
  /** Draws an item with a material that writes its coverage of pixels to red; the greatest value is kept. */
  draw(frame: Frame, item: RenderItem, material: Material): void;
}
