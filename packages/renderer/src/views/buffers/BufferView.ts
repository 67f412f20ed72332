import type { Frame } from '../../frame/Frame';
import type { ViewInfo } from '../../frame/ViewInfo';
import type { View } from '../../frame/views';

/** A view of a buffer of an effect, a technique or lights. */
export interface BufferView {
  /**
   * Draws the buffer over the frame's viewport, and fills `info`.
   * @returns null, or a sentence that says what the frame lacks, and how to get it
   */
  show(frame: Frame, info: ShownView): string | null;
  dispose(): void;
}

/** Writable `ViewInfo`, filled by views. */
export interface ShownView extends ViewInfo {
  view: View;
  fullMotion: number;
}
