import type { Light } from 'three';
import type { View } from './views';

/** A rectangle of a view that shows several maps, slices or sums beside one another. */
export interface ViewTile {
  /** Left edge of the rectangle, as a share of the view's width. */
  x: number;
  /** Upper edge of the rectangle, from the view's upper edge, as a share of the view's height. */
  y: number;
  /** Width of the rectangle, as a share of the view's. */
  width: number;
  /** Height of the rectangle, as a share of the view's. */
  height: number;
  /** English name, in which `{number}`, `{count}`, `{near}` and `{far}` stand for the values below. */
  label: string;
  /** Index of the face, cascade or slice, from 1. */
  number: number;
  /** Number of faces, cascades or slices. */
  count: number;
  /** Distance (m) that is shown black, or at which a slice begins; 0 where there is none. */
  near: number;
  /** Distance (m) that is shown white, or at which a slice ends; 0 where there is none. */
  far: number;
  /** Light that the tile belongs to; null for none. */
  light: Light | null;
}

/** State of a view of a buffer in the last frame: its parts and scale, or what the frame lacks for it. */
export interface ViewInfo {
  /** Name of the view. */
  view: View;
  /**
   * Sentence on what the frame lacks, and how to get it, while the final picture is shown instead; null while the buffer is
   * shown.
   */
  problem: string | null;
  /** Motion (pixels a frame) that is shown in full brightness; 0 in other views. */
  fullMotion: number;
  /** Parts of the view, empty if it has none. The same objects every frame: read, do not keep. */
  tiles: readonly ViewTile[];
}
