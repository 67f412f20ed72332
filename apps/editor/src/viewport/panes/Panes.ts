import { Vector3 } from 'three';
import type { Shading } from '../shading/Shading';
import type { Bounds } from './paneSurface';
import { halfShare, limitShare, type PaneShare } from './PaneShare';
import { type PaneRectangle, ViewPane } from './ViewPane';

/** The views beside the main one: name, and direction from what is seen to the eye. */
const sides = [
  ['top', new Vector3(0, 1, 0)],
  ['front', new Vector3(0, 0, 1)],
  ['right', new Vector3(1, 0, 0)],
] as const;

/** Between two panes (CSS pixels). */
const GAP = 2;

/**
 * The views of the picture: one, or four, each with a camera of its own. The pointer and the keys go to the active one: the
 * last that the pointer was over.
 */
export class Panes {
  readonly main: ViewPane;
  /** Of views beside the main one, when they are made. */
  sideShading: Shading = 'clay';
  private panes: readonly ViewPane[];
  private current: ViewPane;
  private part: PaneShare = halfShare;
  private width = 1;
  private height = 1;

  /**
   * @param hasKeys - whether keys are the controls', asked at each
   * @param activated - called when another view is active
   */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly hasKeys: () => boolean,
    private readonly activated: () => void,
  ) {
    // before all that listens to the canvas
    canvas.addEventListener('pointerdown', this.pointerMoved, true);
    canvas.addEventListener('pointermove', this.pointerMoved, true);
    canvas.addEventListener('wheel', this.pointerMoved, { capture: true, passive: true });
    this.main = this.make('main', 'scene');
    this.panes = [this.main];
    this.current = this.main;
    this.main.editorCamera.active = true;
  }

  get list(): readonly ViewPane[] {
    return this.panes;
  }

  get active(): ViewPane {
    return this.current;
  }

  set active(pane: ViewPane) {
    if (pane === this.current) return;
    this.current.editorCamera.active = false;
    this.current = pane;
    pane.editorCamera.active = true;
    this.activated();
  }

  /** Whether there are four views. */
  get isQuad(): boolean {
    return this.panes.length > 1;
  }

  set isQuad(isQuad: boolean) {
    if (isQuad === this.isQuad) return;
    if (isQuad) {
      this.panes = [this.main, ...sides.map(([name]) => this.make(name, this.sideShading))];
      this.lookFromSides();
    } else {
      this.active = this.main;
      for (const { editorCamera } of this.panes.slice(1)) editorCamera.dispose();
      this.panes = [this.main];
    }
    this.resize(this.width, this.height);
  }

  /** What the views at the left and above take of the picture. */
  get share(): PaneShare {
    return this.part;
  }

  set share(share: PaneShare) {
    this.part = limitShare(share);
    this.resize(this.width, this.height);
  }

  /** Shows what the main view shows from above, from the front and from the right. */
  lookFromSides(): void {
    const { target, fov } = this.main.editorCamera.pose;
    const { distance } = this.main.editorCamera;
    for (const pane of this.panes) {
      const direction = sides.find(([name]) => name === pane.name)?.[1];
      if (!direction) continue;
      const position = direction
        .clone()
        .multiplyScalar(distance)
        .add(new Vector3(...target))
        .toArray();
      pane.editorCamera.show({ position, target, fov, orthographic: true }, false);
    }
  }

  /** The active view's part of the page. */
  get bounds(): Bounds {
    return this.current.bounds;
  }

  /** Makes the view active that is at a point of the page. */
  activateAt(clientX: number, clientY: number): void {
    const { left, top } = this.canvas.getBoundingClientRect();
    const [x, y] = [clientX - left, clientY - top];
    for (const pane of this.panes) {
      const { rectangle } = pane;
      const isIn =
        x >= rectangle.x && y >= rectangle.y && x < rectangle.x + rectangle.width && y < rectangle.y + rectangle.height;
      if (isIn) this.active = pane;
    }
  }

  /** Makes the next view active, or the one before. */
  activateNext(by: 1 | -1): void {
    const { panes } = this;
    this.active = panes[(panes.indexOf(this.current) + by + panes.length) % panes.length];
  }

  /** Tells the size of the whole picture (CSS pixels). */
  resize(width: number, height: number): void {
    this.width = width;
    this.height = height;
    for (const pane of this.panes) {
      pane.rectangle = this.place(pane);
      pane.editorCamera.resize(pane.rectangle.width, pane.rectangle.height);
    }
  }

  /** Moves the views on. @returns whether a picture changes */
  update(deltaSeconds: number): boolean {
    let changed = false;
    for (const pane of this.panes) {
      if (pane !== this.main && pane.editorCamera.update(deltaSeconds)) changed = true;
    }
    return changed;
  }

  /** From now on the cameras hear of the pointer after all that listens to the canvas now. */
  listenLast(): void {
    for (const { editorCamera } of this.panes) editorCamera.listenLast();
  }

  dispose(): void {
    const { canvas } = this;
    canvas.removeEventListener('pointerdown', this.pointerMoved, true);
    canvas.removeEventListener('pointermove', this.pointerMoved, true);
    canvas.removeEventListener('wheel', this.pointerMoved, true);
    for (const { editorCamera } of this.panes) editorCamera.dispose();
  }

  private make(name: ViewPane['name'], shading: Shading): ViewPane {
    return new ViewPane(name, shading, this.canvas, this.hasKeys);
  }

  /** Top at the left above, the main view beside it, the front below, and the right beside that. */
  private place({ name }: ViewPane): PaneRectangle {
    const { width, height } = this;
    if (!this.isQuad) return { x: 0, y: 0, width, height };
    const isRight = name === 'main' || name === 'right';
    const isBelow = name === 'front' || name === 'right';
    const { x, y } = this.part;
    const size = {
      width: Math.max(1, Math.floor((width - GAP) * (isRight ? 1 - x : x))),
      height: Math.max(1, Math.floor((height - GAP) * (isBelow ? 1 - y : y))),
    };
    return { x: isRight ? width - size.width : 0, y: isBelow ? height - size.height : 0, ...size };
  }

  private readonly pointerMoved = (event: PointerEvent | WheelEvent): void => {
    if (this.panes.length === 1 || (event.type === 'pointermove' && event.buttons !== 0)) return;
    // a second finger belongs to where the first one is
    if (event.type === 'pointerdown' && !(event as PointerEvent).isPrimary) return;
    this.activateAt(event.clientX, event.clientY);
  };
}
