import { Signal } from '@farol/editing';
import { Raycaster, Vector2, Vector3 } from 'three';
import type { Tool } from '../../model/Tools';
import { DragReadout } from '../handles/DragReadout';
import { nearestVertex } from '../handles/nearestVertex';
import { LineSet } from '../LineSet';
import { PictureClicks } from '../PictureClicks';
import type { Viewport } from '../Viewport';
import { groundAlong, surfacesAlong } from './surfaces';

/** Distance (CSS pixels) within which a vertex is preferred to the point under the pointer. */
const VERTEX_REACH = 12;
/** Distance up to which the ground is hit (m). */
const FARTHEST = 1000;

const none: ReadonlySet<never> = new Set();
const raycaster = new Raycaster();
const projected = new Vector3();

/** Length in mm, cm or m, depending on its size. @param length - m */
export function lengthText(length: number): string {
  const size = Math.abs(length);
  if (size === 0 || size >= 1) return `${Number(length.toFixed(3)) + 0} m`;
  return size >= 0.01 ? `${Number((length * 100).toFixed(2))} cm` : `${Number((length * 1000).toFixed(2))} mm`;
}

/**
 * Measures the distance between two clicked points on meshes, or else on the ground at height 0. Snaps to vertices
 * close to the pointer.
 */
export class MeasureTool implements Tool {
  readonly id = 'measure';
  /** Emits when a point is set, or the second one follows the pointer. */
  readonly changed = new Signal();

  private readonly lines = new LineSet('#4fc3f7');
  private readonly readout: DragReadout;
  private readonly clicks: PictureClicks;
  private first: Vector3 | null = null;
  private second: Vector3 | null = null;
  private isDone = false;

  constructor(private readonly viewport: Viewport) {
    const { canvas, helpers } = viewport;
    this.readout = new DragReadout(canvas);
    this.clicks = new PictureClicks(viewport, (x, y) => this.clicked(x, y));
    canvas.addEventListener('pointermove', this.pointerMove, true);
    helpers.scene.add(this.lines.three);
    this.lines.end();
  }

  /** Ends of the measured line (m, world); the second follows the pointer until clicked. Null until there are two. */
  get ends(): readonly [Vector3, Vector3] | null {
    return this.first && this.second ? [this.first, this.second] : null;
  }

  end(): void {
    const { canvas, helpers } = this.viewport;
    this.clicks.end();
    canvas.removeEventListener('pointermove', this.pointerMove, true);
    helpers.scene.remove(this.lines.three);
    this.lines.dispose();
    this.readout.hide();
  }

  /** The point under the pointer, and whether it is a vertex. */
  private pointAt(clientX: number, clientY: number): { point: Vector3; isVertex: boolean } | null {
    const { viewport } = this;
    const { left, top, width, height } = viewport.bounds;
    const at = new Vector2(((clientX - left) / width) * 2 - 1, 1 - ((clientY - top) / height) * 2);
    const camera = viewport.rayCamera;
    raycaster.setFromCamera(at, camera);
    const { ray } = raycaster;
    const { scene } = viewport.document;
    const vertex = nearestVertex(scene, ray, camera, none);
    if (vertex) {
      projected.copy(vertex).project(camera);
      const away = Math.hypot(((projected.x - at.x) * width) / 2, ((projected.y - at.y) * height) / 2);
      if (away <= VERTEX_REACH) return { point: vertex, isVertex: true };
    }
    const surface = surfacesAlong(scene, ray, camera).at(0) ?? groundAlong(ray, FARTHEST);
    return surface && { point: surface.point, isVertex: false };
  }

  private draw(): void {
    const { lines, first, second } = this;
    lines.begin();
    if (first && second) {
      // draws one line along each axis, then the direct line
      const corners = [
        first,
        new Vector3(second.x, first.y, first.z),
        new Vector3(second.x, first.y, second.z),
        second,
      ];
      for (let i = 0; i < 3; i++) lines.line(corners[i], corners[i + 1]);
      lines.line(first, second);
    }
    lines.end();
    this.viewport.invalidate();
    this.changed.emit();
  }

  private readonly pointerMove = (event: PointerEvent): void => {
    if (event.buttons !== 0) return;
    const at = this.pointAt(event.clientX, event.clientY);
    const { left, top } = this.viewport.canvas.getBoundingClientRect();
    const x = event.clientX - left;
    const y = event.clientY - top;
    if (!at) this.readout.markAt(null);
    else {
      const { bounds, rayCamera } = this.viewport;
      projected.copy(at.point).project(rayCamera);
      const mark = {
        x: bounds.left - left + ((projected.x + 1) / 2) * bounds.width,
        y: bounds.top - top + ((1 - projected.y) / 2) * bounds.height,
      };
      this.readout.markAt(at.isVertex ? mark : null);
    }
    if (!this.first || this.isDone) return;
    this.second = at?.point ?? null;
    if (this.second) this.readout.show([{ axis: '', text: lengthText(this.first.distanceTo(this.second)) }], x, y);
    this.draw();
  };

  private async clicked(x: number, y: number): Promise<void> {
    const at = this.pointAt(x, y);
    if (!at) return;
    if (!this.first || this.isDone) {
      this.first = at.point;
      this.second = null;
      this.isDone = false;
    } else {
      this.second = at.point;
      this.isDone = true;
    }
    this.draw();
  }
}
