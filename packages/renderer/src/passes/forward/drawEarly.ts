import type { Frame } from '../../frame/Frame';
import type { ForwardTwins } from '../../materials/forwardTwin';

/**
 * Draws the `early` items into the host's target, in three's order, before all other items.
 * @param twins - twins of a loop over all lights, since light lists are not drawn yet
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
