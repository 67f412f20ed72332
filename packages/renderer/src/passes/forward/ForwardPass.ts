import { forwardTwins } from '../../materials/forwardTwin';
import type { ForwardTwins } from '../../materials/forwardTwin';
import { hasDepthTwin } from '../../materials/depthTwin';
import type { Frame } from '../../frame/Frame';
import { isGouraud } from '../../materials/shadingOf';
import type { RenderItem } from '../../frame/RenderItem';
import { BackgroundDraw } from '../output/BackgroundDraw';
import type { Pass, Resource } from '../../frame/Pass';
import type { LightLoop } from '../../materials/LightLoop';

/** Options of the constructor of ForwardPass. */
export interface ForwardPassOptions {
  readonly name: string;
  readonly list: 'opaque' | 'transmissive' | 'transparent';
  readonly loop: LightLoop;
  /** Light loop for opaque items whose depth no earlier pass has drawn; default `loop`. */
  readonly loopOutside?: LightLoop;
  readonly reads?: readonly Resource[];
  /** Whether no pass before it draws opaque items, whose materials may then be reordered. Default false. */
  readonly isFirst?: boolean;
}

/**
 * Draws the remaining items of one of three's lists into the host's target, each lit item once, by the lights of the
 * loop.
 */
export class ForwardPass implements Pass {
  readonly name: string;
  readonly reads: readonly Resource[];
  readonly writes: readonly Resource[];
  readonly bytes = 0;
  private readonly list: ForwardPassOptions['list'];
  private readonly loop: LightLoop;
  private readonly loopOutside: LightLoop;
  private readonly isFirst: boolean;
  private readonly background = new BackgroundDraw();
  private readonly twins: ReturnType<typeof forwardTwins>;
  private readonly outside: ReturnType<typeof forwardTwins>;

  constructor(options: ForwardPassOptions) {
    this.name = options.name;
    this.list = options.list;
    this.reads = options.reads ?? [];
    this.writes = options.list === 'transmissive' ? ['target'] : ['target', options.list];
    const { loop, loopOutside = loop } = options;
    this.isFirst = options.isFirst ?? false;
    this.loop = loop;
    this.loopOutside = loopOutside;
    this.twins = forwardTwins(loop);
    this.outside = loopOutside === loop ? this.twins : forwardTwins(loopOutside);
  }

  isIdle({ queue, fills, view }: Frame): boolean {
    return (queue[this.list].length === 0 && !(this.list === 'opaque' && fills === 'behind')) || view === 'overdraw';
  }

  render(frame: Frame): void {
    const { queue } = frame;
    if (this.list === 'transparent') frame.resources.put('transparent', queue.transparent);
    if (this.isIdle(frame)) return;
    frame.bindTarget();
    const twins = (frame.fields?.twinsFor(this.loop) ?? this.twins)(frame.view);
    const outside = (frame.fields?.twinsFor(this.loopOutside) ?? this.outside)(frame.view);
    const onlyLit = frame.view !== 'final' && frame.view !== 'grid';
    for (const item of this.isFirst ? frame.beginOrder() : queue[this.list]) {
      const isInside = twins === outside || (item.route === 'split' && hasDepthTwin(item.material));
      this.draw(frame, item, isInside ? twins : outside, onlyLit);
    }
    queue.endOrder();
    if (this.list === 'opaque' && frame.fills === 'behind') this.background.draw(frame);
  }

  dispose(): void {
    this.background.dispose();
  }

  private draw(frame: Frame, item: RenderItem, twins: ForwardTwins, onlyLit: boolean): void {
    const lit = item.shading === 'lit';
    if (item.drawn || (onlyLit && !lit)) return;
    const vertex = lit && item.ownShader && isGouraud(item.material) ? frame.gouraudTwins() : null;
    frame.drawForward(item, vertex ?? twins);
  }
}
