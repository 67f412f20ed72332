import type { FieldEdit, Gesture, SetFields } from '@farol/editing';
import type { GameObject } from '@farol/engine';
import {
  BufferGeometry,
  type Camera,
  Float32BufferAttribute,
  Points,
  PointsMaterial,
  type Ray,
  Raycaster,
  Vector2,
  Vector3,
} from 'three';
import type { EditorDocument } from '../../model/EditorDocument';
import type { Bounds } from '../panes/paneSurface';
import { DragReadout } from './DragReadout';
import './handles.css';

/** Largest distance to a handle (CSS pixels) at which a mouse can grab it; below, the same for a finger. */
const REACH = 9;
const FINGER_REACH = 18;
/** Width of a drawn handle (CSS pixels). */
const SIZE = 9;
/** Rounding of sizes and positions without snapping (m). */
const FINE = 0.01;

const seen = new Vector3();

/** A point in the viewport that can be dragged. */
export interface Handle {
  /** World position of the handle (m). */
  readonly place: Vector3;
  /**
   * Edit for a drag to the pointer's ray; null when the ray determines no position.
   * @param step - rounding of sizes (m)
   * @param viewDirection - direction of the camera
   */
  drag(ray: Ray, step: number, viewDirection: Vector3): SetFields | null;
  /** Text beside the pointer during a drag; none when absent. */
  textOf?(edits: readonly FieldEdit[]): string;
}

/** The part of the viewport that handles use. */
export interface HandleHost {
  readonly document: EditorDocument;
  readonly canvas: HTMLCanvasElement;
  /** Rectangle of the active view on the page. */
  readonly bounds: Bounds;
  /** Camera of the active view, for raycasting. */
  readonly rayCamera: Camera;
  readonly gizmo: { readonly snapping: boolean; readonly snapSteps: { readonly translate: number } };
  invalidate(): void;
}

/** Rounds to a multiple of a step, without floating-point noise. */
export const roundTo = (value: number, step: number): number => Number((Math.round(value / step) * step).toFixed(4));

/** Distance along a line from its origin to the point closest to a ray; null when they are parallel. */
export function alongLine(origin: Vector3, direction: Vector3, ray: Ray): number | null {
  const between = origin.clone().sub(ray.origin);
  const cosine = direction.dot(ray.direction);
  const sine = 1 - cosine * cosine;
  if (sine < 1e-4) return null;
  return (cosine * ray.direction.dot(between) - direction.dot(between)) / sine;
}

/**
 * Handles that resize the selected object, when exactly one is selected. One drag is one step of history; Escape
 * cancels it.
 */
export class HandlePoints {
  readonly three: Points<BufferGeometry, PointsMaterial>;

  private handles: Handle[] = [];
  private gesture: Gesture | null = null;
  private dragged: Handle | null = null;
  private readonly readout: DragReadout;
  private readonly raycaster = new Raycaster();
  private readonly pointer = new Vector2();
  private readonly direction = new Vector3();
  private readonly abort = new AbortController();

  /**
   * @param colour - CSS colour
   * @param handlesOf - handles of an object in its current pose
   * @param clearance - handles closer on screen than this to the object's origin are hidden, since the gizmo is there
   *   (CSS pixels). Default 0
   */
  constructor(
    private readonly host: HandleHost,
    colour: string,
    private readonly handlesOf: (object: GameObject) => Handle[],
    private readonly clearance = 0,
  ) {
    const material = new PointsMaterial({ color: colour, size: SIZE, sizeAttenuation: false, depthTest: false });
    material.transparent = true;
    material.toneMapped = false;
    this.three = new Points(new BufferGeometry(), material);
    this.three.frustumCulled = false;
    this.readout = new DragReadout(host.canvas);
    const options = { signal: this.abort.signal, capture: true };
    // these listeners are registered first, so that they run before those of camera, gizmo and picker
    host.canvas.addEventListener('pointerdown', (event) => this.pointerDown(event), options);
    host.canvas.addEventListener('pointermove', (event) => this.pointerMove(event), options);
    host.canvas.addEventListener('pointerup', (event) => this.pointerUp(event), options);
    host.canvas.addEventListener('pointercancel', () => this.cancel(), options);
    window.addEventListener(
      'keydown',
      (event) => event.key === 'Escape' && this.cancel() && event.stopPropagation(),
      options,
    );
  }

  /** World positions of the handles, for tests. */
  get places(): readonly Vector3[] {
    return this.handles.map(({ place }) => place);
  }

  /** Places the handles for a frame. @param pixelRatio - pixel ratio of the canvas */
  update(pixelRatio: number): void {
    this.three.material.size = SIZE * pixelRatio;
    const { document } = this.host;
    const [object, second] = document.selectedObjects;
    const isHandled = object && !second && !object.lockedInHierarchy && document.simulation.state === 'stopped';
    // during a drag the handles are kept, with their initial positions
    if (!this.dragged) this.handles = isHandled ? this.clearOf(object, this.handlesOf(object)) : [];
    const visibleHandles = this.dragged && isHandled ? this.handlesOf(object) : this.handles;
    this.three.visible = visibleHandles.length > 0;
    if (visibleHandles.length === 0) return;
    const positions = visibleHandles.flatMap(({ place }) => place.toArray());
    const attribute = this.three.geometry.getAttribute('position') as Float32BufferAttribute | undefined;
    if (attribute?.count === visibleHandles.length) {
      attribute.copyArray(positions);
      attribute.needsUpdate = true;
    } else {
      this.three.geometry.dispose();
      this.three.geometry.setAttribute('position', new Float32BufferAttribute(positions, 3));
    }
  }

  dispose(): void {
    this.cancel();
    this.abort.abort();
    this.three.geometry.dispose();
    this.three.material.dispose();
  }

  private clearOf({ object3D }: GameObject, handles: Handle[]): Handle[] {
    if (this.clearance === 0) return handles;
    const middle = this.seenAt(seen.setFromMatrixPosition(object3D.matrixWorld));
    if (!middle) return handles;
    return handles.filter(({ place }) => {
      const at = this.seenAt(seen.copy(place));
      return at && Math.hypot(at.x - middle.x, at.y - middle.y) >= this.clearance;
    });
  }

  /** Page position (CSS pixels) of a world point; null behind the camera. Overwrites `point`. */
  private seenAt(point: Vector3): { x: number; y: number } | null {
    const { bounds, rayCamera } = this.host;
    const { x, y, z } = point.project(rayCamera);
    if (z > 1) return null;
    return { x: bounds.left + ((x + 1) / 2) * bounds.width, y: bounds.top + ((1 - y) / 2) * bounds.height };
  }

  private pointerDown(event: PointerEvent): void {
    if (event.button !== 0 || !event.isPrimary) return;
    const handle = this.handleAt(event);
    if (!handle) return;
    event.stopImmediatePropagation();
    this.host.canvas.setPointerCapture(event.pointerId);
    this.dragged = handle;
    this.gesture = this.host.document.commands.begin();
  }

  private pointerMove(event: PointerEvent): void {
    const { dragged, gesture, host } = this;
    if (!dragged) {
      if (this.handles.length > 0 && event.buttons === 0)
        host.canvas.style.cursor = this.handleAt(event) ? 'pointer' : '';
      return;
    }
    event.stopImmediatePropagation();
    if (!gesture?.isOpen) return;
    this.aim(event);
    host.rayCamera.getWorldDirection(this.direction);
    const isStepped = host.gizmo.snapping !== event.ctrlKey;
    const step = isStepped ? host.gizmo.snapSteps.translate : FINE;
    const command = dragged.drag(this.raycaster.ray, step, this.direction);
    if (!command) return;
    gesture.preview(command);
    const text = dragged.textOf?.(command.edits);
    if (text === undefined) return;
    const { left, top } = host.canvas.getBoundingClientRect();
    this.readout.show([{ axis: '', text }], event.clientX - left, event.clientY - top);
  }

  private pointerUp(event: PointerEvent): void {
    if (!this.dragged) return;
    event.stopImmediatePropagation();
    this.gesture?.commit();
    this.release();
  }

  /** Cancels the drag. @returns whether one was in progress */
  private cancel(): boolean {
    if (!this.dragged) return false;
    this.gesture?.discard();
    this.release();
    return true;
  }

  private release(): void {
    this.dragged = this.gesture = null;
    this.readout.hide();
    this.host.canvas.style.cursor = '';
    this.host.invalidate();
  }

  private aim({ clientX, clientY }: PointerEvent): void {
    const { left, top, width, height } = this.host.bounds;
    this.pointer.set(((clientX - left) / width) * 2 - 1, 1 - ((clientY - top) / height) * 2);
    this.raycaster.setFromCamera(this.pointer, this.host.rayCamera);
  }

  private handleAt({ clientX, clientY, pointerType }: PointerEvent): Handle | null {
    let nearest: Handle | null = null;
    let leastDistance = pointerType === 'touch' ? FINGER_REACH : REACH;
    for (const handle of this.handles) {
      const at = this.seenAt(seen.copy(handle.place));
      if (!at) continue;
      const distance = Math.hypot(at.x - clientX, at.y - clientY);
      if (distance < leastDistance) [nearest, leastDistance] = [handle, distance];
    }
    return nearest;
  }
}
