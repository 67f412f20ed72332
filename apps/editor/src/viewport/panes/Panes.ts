import { Vector3 } from 'three';
import type { Shading } from '../shading/Shading';
import type { PointerControls } from '../PointerControls';
import type { Bounds } from './paneSurface';
import { halfShare, limitShare, type PaneShare } from './PaneShare';
import { type PaneRectangle, ViewPane } from './ViewPane';

/** Side views: name, and direction from the target to the eye. */
const sides = [
  ['top', new Vector3(0, 1, 0)],
  ['front', new Vector3(0, 0, 1)],
  ['right', new Vector3(1, 0, 0)],
] as const;

/** Gap between views (CSS pixels). */
const GAP = 2;

/**
 * The views of the viewport: one, or four, each with its own camera. Pointer and keys go to the active view, which is
 * the last one that the pointer was over.
 */
export class Panes {
  readonly main: ViewPane;
  /** Initial shading of side views. */
  sideShading: Shading = 'clay';
  private panes: readonly ViewPane[];
  private current: ViewPane;
  private part: PaneShare = halfShare;
  private width = 1;
  private height = 1;
  private Controls: typeof PointerControls | null = null;

  /**
   * @param hasKeys - called at each key press: whether camera controls may use the key
   * @param activated - called when another view becomes active
   */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly hasKeys: () => boolean,
    private readonly activated: () => void,
  ) {
    // pointer events are captured before other listeners run, which then find the view under the pointer active
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

  /** Share of the viewport that each view has. */
  get share(): PaneShare {
    return this.part;
  }

  set share(share: PaneShare) {
    const { x, y } = limitShare(share);
    if (x === this.part.x && y === this.part.y) return;
    this.part = { x, y };
    this.resize(this.width, this.height);
  }

  /** Aims the side views at the main view's target again, in their own directions. */
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

  /** Rectangle of the active view on the page. */
  get bounds(): Bounds {
    return this.current.bounds;
  }

  /** Activates the view at a point of the page (CSS pixels). */
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

  /** Activates the next or the previous view. */
  activateNext(by: 1 | -1): void {
    const { panes } = this;
    this.active = panes[(panes.indexOf(this.current) + by + panes.length) % panes.length];
  }

  /** Sets the size of the whole viewport (CSS pixels). */
  resize(width: number, height: number): void {
    this.width = width;
    this.height = height;
    for (const pane of this.panes) {
      pane.rectangle = this.place(pane);
      pane.editorCamera.resize(pane.rectangle.width, pane.rectangle.height);
    }
  }

  /** Advances the cameras. @returns whether a view changed */
  update(deltaSeconds: number): boolean {
    let changed = false;
    for (const pane of this.panes) {
      if (pane !== this.main && pane.editorCamera.update(deltaSeconds)) changed = true;
    }
    return changed;
  }

  /** Lets pointer, wheel and keys move the cameras, also of views that are opened later. */
  control(Controls: typeof PointerControls): void {
    this.Controls = Controls;
    for (const { editorCamera } of this.panes) editorCamera.control(Controls);
  }

  /** Registers the cameras' pointer listeners again, so that they run after the canvas's other listeners. */
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
    const pane = new ViewPane(name, shading, this.canvas, this.hasKeys);
    if (this.Controls) pane.editorCamera.control(this.Controls);
    return pane;
  }

  /** Rectangle of a view: top view upper left, main view upper right, front view lower left, right view lower right. */
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
    // a second finger goes to the view of the first one
    if (event.type === 'pointerdown' && !(event as PointerEvent).isPrimary) return;
    this.activateAt(event.clientX, event.clientY);
  };
}
