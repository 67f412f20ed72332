import type { FarolRenderer } from '../../FarolRenderer';

/**
 * Fulfilled when the last frame lacked no code and no change of technique is under way: at once where that is so, else
 * after a frame of the host's.
 * @throws Error when code cannot be fetched, or the renderer is disposed
 */
export async function whenReady(farol: FarolRenderer): Promise<void> {
  const last = farol['last'];
  const picker = farol['picker'];
  for (;;) {
    await Promise.all(Array.from(last.lacking, (part) => part.load()));
    if (farol['disposed'])
      throw new Error('Farol: the renderer was disposed before it was ready; make a new FarolRenderer.');
    if (last.isDrawn && last.lacking.size === 0) {
      if (!picker.isChanging) return;
      last.redraw();
    }
    await new Promise<void>((resolve) => last.waiting.push(resolve));
  }
}
