import { LateCode } from '../base/LateCode';
import type { LastPicture } from './LastPicture';

/** Part of PictureRenderer that {@link whenDrawn} reads. */
export interface DrawnPicture {
  readonly last: LastPicture;
  /** Promise of the renderer that all code and programs of its last frame are ready. */
  readonly farol: { readonly ready: Promise<void> };
  /** Number of frames until a changed picture is final. */
  readonly effects: { readonly frames: number };
}

/**
 * Resolves when the picture of the last drawn scene is final; see `PictureRenderer.ready`.
 * @throws Error (as a rejection) when code cannot be fetched, or the renderer is disposed
 */
export async function whenDrawn({ last, farol, effects }: DrawnPicture): Promise<void> {
  for (;;) {
    await Promise.all(LateCode.fetching);
    await last.scene?.assets.settled();
    // the number of frames is known after the first frame on a device
    for (let drawn = 0; drawn < effects.frames; drawn++) await nextFrame(last);
    await farol.ready;
    if (!last.isStale && LateCode.fetching.size === 0 && last.scene!.assets.isSettled) return;
  }
}

/** Requests a frame, and resolves once it is drawn. */
async function nextFrame(last: LastPicture): Promise<void> {
  if (!last.isDisposed) {
    const drawn = new Promise<void>((resolve) => last.waiting.push(resolve));
    last.redraw();
    await drawn;
  }
  if (last.isDisposed) throw new Error('The picture was disposed before it was ready: make a new one.');
}
