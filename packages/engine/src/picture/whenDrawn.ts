import { LateCode } from '../base/LateCode';
import type { LastPicture } from './LastPicture';

/** Part of PictureRenderer that {@link whenDrawn} reads. */
export interface DrawnPicture {
  readonly last: LastPicture;
  /** Whether the renderer has what its last frame asked for. */
  readonly farol: { readonly ready: Promise<void> };
  /** Frames to draw until a picture that changed is as it stays. */
  readonly effects: { readonly frames: number };
}

/**
 * Fulfilled when the scene that a renderer has drawn last is drawn as it stays; see `PictureRenderer.ready`.
 * @throws Error (as a rejection) when code cannot be fetched, or the renderer is disposed
 */
export async function whenDrawn({ last, farol, effects }: DrawnPicture): Promise<void> {
  for (;;) {
    await Promise.all(LateCode.fetching);
    await last.scene?.assets.settled();
    // the first frame on a device tells how many it takes
    for (let drawn = 0; drawn < effects.frames; drawn++) await nextFrame(last);
    await farol.ready;
    if (!last.isStale && LateCode.fetching.size === 0 && last.scene!.assets.isSettled) return;
  }
}

/** Asks for a frame, and is fulfilled when one is drawn. */
async function nextFrame(last: LastPicture): Promise<void> {
  if (!last.isDisposed) {
    const drawn = new Promise<void>((resolve) => last.waiting.push(resolve));
    last.redraw();
    await drawn;
  }
  if (last.isDisposed) throw new Error('The picture was disposed before it was ready: make a new one.');
}
