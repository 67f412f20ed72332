import type { Gesture } from '@farol/editing';
import { CharacterController, Collider, Joint, type GameObject } from '@farol/engine';
import {
  BufferGeometry,
  type Camera,
  Float32BufferAttribute,
  Object3D,
  Points,
  PointsMaterial,
  Raycaster,
  Vector2,
  Vector3,
} from 'three';
import type { EditorDocument } from '../../model/EditorDocument';
import { LineSet } from '../LineSet';
import type { Bounds } from '../panes/paneSurface';
import { drawCollider } from './colliderLines';
import { drawCharacter, drawJoint } from './jointLines';
import { colliderHandles, type Handle, jointHandles } from './shapeHandles';

/** Of what is selected. */
const COLOUR = '#63e28a';
/** Of what is not. */
const QUIET = '#3f8f5a';
/** How near to a handle the pointer takes it (CSS pixels). */
const REACH = 9;
/** To which sizes and places are rounded without steps (m). */
const FINE = 0.01;

/** What the overlay needs of the viewport. */
export interface OverlayHost {
  readonly document: EditorDocument;
  readonly canvas: HTMLCanvasElement;
  /** Where on the page the view is that the pointer works in. */
  readonly bounds: Bounds;
  /** Sees what that view shows. */
  readonly rayCamera: Camera;
  readonly gizmo: { readonly snapping: boolean; readonly snapSteps: { readonly translate: number } };
  /** Whether the colliders of all objects are drawn, not of selected ones alone. */
  readonly showColliders: boolean;
  invalidate(): void;
}

/** Colliders, joints and characters as lines over the picture, and handles that size and move those of the selected object. */
export class PhysicsOverlay {
  readonly three = new Object3D();

  private readonly selected = new LineSet(COLOUR);
  private readonly others = new LineSet(QUIET);
  private readonly points: Points<BufferGeometry, PointsMaterial>;
  private handles: Handle[] = [];
  private othersKey = 'none';
  private gesture: Gesture | null = null;
  private dragged: Handle | null = null;
  private readonly raycaster = new Raycaster();
  private readonly pointer = new Vector2();
  private readonly direction = new Vector3();
  private readonly abort = new AbortController();

  constructor(private readonly host: OverlayHost) {
    const material = new PointsMaterial({ color: COLOUR, size: 9, sizeAttenuation: false, depthTest: false });
    material.transparent = true;
    material.toneMapped = false;
    this.points = new Points(new BufferGeometry(), material);
    this.points.frustumCulled = false;
    this.three.add(this.others.three, this.selected.three, this.points);
    const options = { signal: this.abort.signal, capture: true };
    // before the camera, the gizmo and the picker hear of it
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

  /** Where the handles are in the world: for tests. */
  get places(): readonly Vector3[] {
    return this.handles.map(({ place }) => place);
  }

  /** How many lines are drawn of what is selected, and of the rest: for tests. */
  get lineCounts(): { readonly selected: number; readonly others: number } {
    return { selected: this.selected.count, others: this.others.count };
  }

  /** Called before each picture. @param pixelRatio - of the canvas */
  update(pixelRatio: number): void {
    const { document, showColliders } = this.host;
    const { scene, selectedObjects } = document;
    this.selected.begin();
    for (const object of selectedObjects) drawObject(this.selected, object);
    this.selected.end();
    const key = showColliders ? `${document.edited.revision} ${document.selection.changed.revision} ${scene.time}` : '';
    if (key !== this.othersKey) {
      this.othersKey = key;
      const chosen = new Set(document.selection.ids);
      this.others.begin();
      if (showColliders) {
        const show = ({ gameObject }: Collider): boolean => !chosen.has(gameObject.id) && gameObject.activeInHierarchy;
        for (const each of scene.componentsOf(Collider)) if (show(each)) drawCollider(this.others, each);
        for (const each of scene.componentsOf(Joint)) if (!chosen.has(each.gameObject.id)) drawJoint(this.others, each);
        for (const each of scene.componentsOf(CharacterController)) {
          if (!chosen.has(each.gameObject.id)) drawCharacter(this.others, each);
        }
      }
      this.others.end();
    }
    this.points.material.size = 9 * pixelRatio;
    this.placeHandles();
  }

  dispose(): void {
    this.cancel();
    this.abort.abort();
    this.selected.dispose();
    this.others.dispose();
    this.points.geometry.dispose();
    this.points.material.dispose();
  }

  private placeHandles(): void {
    const { document } = this.host;
    const [object, second] = document.selectedObjects;
    const isHandled = object && !second && !object.lockedInHierarchy && document.simulation.state === 'stopped';
    // what is dragged stays the same handle, whose place is where it began
    if (!this.dragged) this.handles = isHandled ? handlesOf(object) : [];
    const shown = this.dragged && isHandled ? handlesOf(object) : this.handles;
    this.points.visible = shown.length > 0;
    if (shown.length === 0) return;
    const positions = shown.flatMap(({ place }) => place.toArray());
    const attribute = this.points.geometry.getAttribute('position') as Float32BufferAttribute | undefined;
    if (attribute?.count === shown.length) {
      attribute.copyArray(positions);
      attribute.needsUpdate = true;
    } else {
      this.points.geometry.dispose();
      this.points.geometry.setAttribute('position', new Float32BufferAttribute(positions, 3));
    }
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
    if (command) gesture.preview(command);
  }

  private pointerUp(event: PointerEvent): void {
    if (!this.dragged) return;
    event.stopImmediatePropagation();
    this.gesture?.commit();
    this.release();
  }

  /** @returns whether a drag was under way */
  private cancel(): boolean {
    if (!this.dragged) return false;
    this.gesture?.discard();
    this.release();
    return true;
  }

  private release(): void {
    this.dragged = this.gesture = null;
    this.host.canvas.style.cursor = '';
    this.host.invalidate();
  }

  private aim({ clientX, clientY }: PointerEvent): void {
    const { left, top, width, height } = this.host.bounds;
    this.pointer.set(((clientX - left) / width) * 2 - 1, 1 - ((clientY - top) / height) * 2);
    this.raycaster.setFromCamera(this.pointer, this.host.rayCamera);
  }

  private handleAt({ clientX, clientY }: PointerEvent): Handle | null {
    const { bounds, rayCamera } = this.host;
    let nearest: Handle | null = null;
    let least = REACH;
    for (const handle of this.handles) {
      const seen = handle.place.clone().project(rayCamera);
      if (seen.z > 1) continue;
      const x = bounds.left + ((seen.x + 1) / 2) * bounds.width;
      const y = bounds.top + ((1 - seen.y) / 2) * bounds.height;
      const distance = Math.hypot(x - clientX, y - clientY);
      if (distance < least) [nearest, least] = [handle, distance];
    }
    return nearest;
  }
}

function drawObject(lines: LineSet, object: GameObject): void {
  for (const component of object.components) {
    if (component instanceof Collider) drawCollider(lines, component);
    else if (component instanceof Joint) drawJoint(lines, component);
    else if (component instanceof CharacterController) drawCharacter(lines, component);
  }
}

const handlesOf = (object: GameObject): Handle[] =>
  object.components.flatMap((component) =>
    component instanceof Collider
      ? colliderHandles(component)
      : component instanceof Joint
        ? jointHandles(component)
        : [],
  );
