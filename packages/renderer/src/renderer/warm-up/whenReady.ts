import type { LastFrame } from '../LastFrame';

/**
 * Fulfilled when the last frame lacked no code and no change of technique is under way: at once, or after a later frame of the
 * host's.
 * @throws Error when code cannot be fetched, or the renderer is disposed
 */
export async function whenReady(
  last: LastFrame,
  picker: { readonly isChanging: boolean },
  isDisposed: () => boolean,
): Promise<void> {
  for (;;) {
    if (isDisposed())
      throw new Error('Farol: the renderer was disposed before it was ready; make a new FarolRenderer.');
    const isComplete = last.isDrawn && last.lacking.size === 0;
    if (isComplete && !picker.isChanging) return;
    // `waiting` is also called when the renderer is disposed
    const drawn = new Promise<void>((resolve) => last.waiting.push(resolve));
    // 'auto' links programs between frames, which hosts that draw on demand draw on 'redraw'
    if (isComplete) setTimeout(last.redraw);
    const loaded = Promise.all(Array.from(last.lacking, (part) => part.load()));
    await Promise.race([drawn, loaded.then(() => drawn)]);
  }
}
