import type { Frame } from '../../frame/Frame';
import type { ForwardTwins } from '../../materials/forwardTwin';

/**
 * Draws into the host's target what must be there before the rest, in three's order.
 * @param twins - of a loop without lists: those are not made yet
 */
export function drawEarly(frame: Frame, twins: ForwardTwins): void {
  const { queue } = frame;
  queue.keepOrder();
  if (queue.early === 0 || frame.view !== 'final') return;
  frame.bindTarget();
  for (let i = 0; i < queue.early; i++) {
    frame.drawForward(queue.opaque[i], twins);
    queue.opaque[i].drawn = true;
  }
}
