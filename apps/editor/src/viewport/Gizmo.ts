import { type Gesture, placePivot } from '@farol/editing';
import type { GameObject } from '@farol/engine';
import { type Camera, MathUtils, Object3D, PerspectiveCamera, Vector3 } from 'three';
import type { TransformControls } from 'three/examples/jsm/controls/TransformControls.js';
import { topmost } from '../model/commands/Placement';
import type { EditorDocument } from '../model/EditorDocument';
import { boundsOf } from './boundsOf';
import type { DragAssist } from './handles/DragAssist';
import type { SnapTarget } from './handles/DragSnap';
import type { PoseDrag } from './handles/PoseDrag';

export type GizmoMode = 'select' | 'translate' | 'rotate' | 'scale';
export type GizmoSpace = 'world' | 'local';
/**
 * Point that several objects rotate and scale about: their common centre, each object's own origin, or the origin of
 * the object selected last.
 */
export type GizmoPivot = 'centre' | 'each' | 'active';

/** Snapping increments of drags. */
export interface SnapSteps {
  /** Increment of moves (m). */
  readonly translate: number;
  /** Increment of rotations (rad). */
  readonly rotate: number;
  /** Increment of scaling, as a share of the size at the start of the drag. */
  readonly scale: number;
}

const middle = new Vector3();

/**
 * Handles that move, rotate and scale the selection: three's TransformControls on a proxy object at its pivot. One drag
 * is one step of history.
 */
export class Gizmo {
  /** three's object of the gizmo, drawn over the viewport. */
  readonly three = new Object3D();

  /** three's handles, fetched when something is first selected; null until then. */
  private controls: TransformControls | null = null;
  private coarsePointer: MediaQueryList | null = null;
  private assist: DragAssist | null = null;
  private isSuspended = false;
  private loading: Promise<void> | null = null;
  private ownSpace: GizmoSpace = 'world';
  private readonly proxy = new Object3D();
  /** Class that moves objects during a drag; null until it is fetched with the handles. */
  private Drag: typeof PoseDrag | null = null;
  private poseDrag: PoseDrag | null = null;
  private targetList: GameObject[] = [];
  private targetsRevision = -1;
  private gesture: Gesture | null = null;
  /** Name of the handle that the drag began with. */
  private grabbed = '';
  private isRegrabbing = false;
  private currentMode: GizmoMode = 'translate';
  private ctrl = false;
  private isSnapping = false;
  private snapTarget: SnapTarget = 'grid';
  /**
   * Whether objects dropped on a surface with the centre handle are rotated so that their y axis is the surface normal.
   */
  alignsToSurface = false;
  pivot: GizmoPivot = 'centre';
  private isDisposed = false;
  private readonly endSelection: () => void;
  private steps: SnapSteps = { translate: 0.5, rotate: MathUtils.degToRad(15), scale: 0.1 };

  /**
   * @param onDrag - called when a drag begins (true) and ends (false)
   * @param onChange - called when the viewport must be redrawn
   * @param onLoad - called when the handles have added their listeners to the canvas
   */
  constructor(
    private readonly document: EditorDocument,
    private readonly canvas: HTMLCanvasElement,
    private readonly onDrag: (isDragging: boolean) => void,
    private readonly onChange: () => void,
    private readonly onLoad: () => void,
  ) {
    this.three.add(this.proxy);
    window.addEventListener('keydown', this.keyChanged, true);
    window.addEventListener('keyup', this.keyChanged, true);
    // handles are detached at once, not with the next frame, so that those of deselected objects cannot be clicked
    this.endSelection = document.selection.changed.subscribe(() => this.detach());
  }

  get mode(): GizmoMode {
    return this.currentMode;
  }

  set mode(mode: GizmoMode) {
    this.cancel();
    this.currentMode = mode;
    if (mode === 'select') this.letGo();
    else if (this.controls) this.controls.mode = mode;
  }

  get space(): GizmoSpace {
    return this.ownSpace;
  }

  set space(space: GizmoSpace) {
    this.ownSpace = space;
    if (this.controls) this.controls.space = space;
  }

  /** Whether drags snap; holding Ctrl inverts it. */
  get snapping(): boolean {
    return this.isSnapping;
  }

  set snapping(snapping: boolean) {
    this.isSnapping = snapping;
    this.applySnapping();
  }

  /** Grid, vertices or surfaces that drags snap to while snapping is on. */
  get snapTo(): SnapTarget {
    return this.snapTarget;
  }

  set snapTo(target: SnapTarget) {
    this.snapTarget = target;
    this.applySnapping();
  }

  /** Hides the handles while something else uses the pointer. */
  set suspended(suspended: boolean) {
    this.isSuspended = suspended;
    if (suspended) this.cancel();
    this.onChange();
  }

  /** Snapping increments, each above 0. */
  get snapSteps(): SnapSteps {
    return this.steps;
  }

  set snapSteps(steps: SnapSteps) {
    this.steps = steps;
    this.applySnapping();
  }

  /** Whether a drag is in progress. */
  get isDragging(): boolean {
    return this.gesture !== null;
  }

  /** Whether a handle is under the pointer, or being dragged. */
  get isHot(): boolean {
    const { controls } = this;
    return controls !== null && (controls.dragging || (controls.axis !== null && controls.object !== undefined));
  }

  /** Called before each frame: follows the selection. @param isHidden - whether handles are hidden for now */
  update(camera: Camera, isHidden = false): void {
    const { controls } = this;
    if (controls) {
      controls.camera = camera;
      // TransformControls scales with the height; in a portrait viewport the width limits the size
      const [x, , , , , y] = camera.projectionMatrix.elements;
      // handles are larger for fingers
      controls.size = (this.coarsePointer?.matches ? 1.3 : 0.85) * Math.min(1, y / x);
    }
    if (controls?.dragging || this.letGo(isHidden)) return;
    this.placeProxy(this.targets());
    if (!controls) this.loading ??= this.load();
    else if (!controls.object) controls.attach(this.proxy);
  }

  /** Cancels a drag, restoring everything. @returns whether there was one */
  cancel(): boolean {
    if (!this.gesture) return false;
    this.gesture.discard();
    this.release();
    return true;
  }

  /** Ends a drag while the pointer is still down. */
  private release(): void {
    this.gesture = null;
    this.assist?.end();
    if (!this.controls) return;
    this.controls.dragging = false;
    this.controls.axis = null;
  }

  dispose(): void {
    window.removeEventListener('keydown', this.keyChanged, true);
    window.removeEventListener('keyup', this.keyChanged, true);
    this.isDisposed = true;
    this.endSelection();
    this.controls?.dispose();
    this.assist?.dispose();
  }

  private async load(): Promise<void> {
    const [{ TransformControls }, { DragAssist }, { PoseDrag: Drag }] = await Promise.all([
      import('three/examples/jsm/controls/TransformControls.js'),
      import('./handles/DragAssist'),
      import('./handles/PoseDrag'),
    ]);
    if (this.isDisposed) return;
    this.Drag = Drag;
    // DragAssist is created first, so that its listeners run before those of the handles
    this.assist = new DragAssist(
      this.canvas,
      () => this.controls?.pointerMove(null),
      (keeps) => {
        if (!keeps) this.cancel();
        else {
          this.gesture?.commit();
          this.release();
        }
      },
      (axis) => this.changeAxis(axis),
    );
    const controls = new TransformControls(new PerspectiveCamera(), this.canvas);
    controls.setColors('#f0525c', '#5fb83e', '#3f86f2', '#ffc857');
    controls.space = this.ownSpace;
    if (this.currentMode !== 'select') controls.mode = this.currentMode;
    this.three.add(controls.getHelper());
    controls.addEventListener('mouseDown', () => this.isRegrabbing || this.begin());
    controls.addEventListener('objectChange', () => this.drag());
    controls.addEventListener('mouseUp', () => this.end());
    controls.addEventListener('dragging-changed', ({ value }) => this.isRegrabbing || this.onDrag(value as boolean));
    controls.addEventListener('change', this.onChange);
    this.coarsePointer = matchMedia('(pointer: coarse)');
    this.controls = controls;
    this.applySnapping();
    this.onLoad();
    this.onChange();
  }

  /**
   * Selected objects that are not locked and not below another selected one. Cached until selection or structure
   * changes, since it is read each frame.
   */
  private targets(): GameObject[] {
    const { selection, structure, selectedObjects, scene } = this.document;
    const revision = selection.changed.revision + structure.revision;
    if (revision !== this.targetsRevision) {
      const free = selectedObjects.filter((object) => !object.lockedInHierarchy);
      this.targetList = free.length < 2 ? free : topmost(free, scene);
      this.targetsRevision = revision;
    }
    return this.targetList;
  }

  /** Hides the handles when there is nothing to move. @returns whether they are hidden */
  private letGo(isHidden = false): boolean {
    const isUsed = this.currentMode !== 'select' && !this.isSuspended && !isHidden;
    if (isUsed && this.targets().length > 0) return false;
    this.detach();
    return true;
  }

  private detach(): void {
    const { controls } = this;
    if (controls?.object && !controls.dragging) controls.detach();
  }

  /** Places the proxy at the pivot of the selection, rotated as the object selected last. */
  private placeProxy(objects: readonly GameObject[]): void {
    const last = objects.at(-1)!.object3D;
    if (objects.length === 1 || this.pivot === 'active') middle.setFromMatrixPosition(last.matrixWorld);
    else boundsOf(objects).getCenter(middle);
    placePivot(this.proxy, middle, last.matrixWorld);
  }

  private begin(): void {
    const objects = this.targets();
    if (objects.length === 0) return; // objects may have been locked since the last frame, so that none is left to move
    this.placeProxy(objects);
    this.gesture = this.document.commands.begin();
    this.poseDrag = new this.Drag!(this.document, objects, this.proxy);
    const { controls, currentMode: mode, proxy: pivot } = this;
    if (!controls || mode === 'select') return;
    const { camera, axis, space } = controls;
    const { scene } = this.document;
    this.grabbed = axis ?? '';
    this.assist?.begin({ scene, camera, mode, axis: this.grabbed, space, dragged: objects, pivot });
  }

  /** Continues the drag with another handle; with the first one again if the drag already uses that handle. */
  private changeAxis(axis: string): void {
    const { controls, assist } = this;
    if (!controls || !assist || !this.gesture) return;
    const next = (controls.axis === axis ? this.grabbed : axis) as TransformControls['axis'];
    const { x, y } = assist.regrab(next ?? '');
    this.isRegrabbing = true;
    controls.dragging = false;
    controls.axis = next;
    controls.getHelper().updateMatrixWorld(true);
    controls.pointerDown({ x, y, button: 0 } as PointerEvent);
    this.isRegrabbing = false;
    controls.pointerMove({ x: assist.place.x, y: assist.place.y, button: -1 } as PointerEvent);
  }

  private drag(): void {
    const { gesture, poseDrag, currentMode: mode } = this;
    if (!gesture?.isOpen || !poseDrag || mode === 'select') return;
    const holdsTo = this.snaps && this.snapTarget !== 'grid' ? this.snapTarget : null;
    const { alignsToSurface } = this;
    const turns = this.assist?.apply({ snapTo: holdsTo, alignsToSurface }) ?? false;
    gesture.preview(poseDrag.command(mode, { each: this.pivot === 'each', turns }));
  }

  private end(): void {
    this.gesture?.commit();
    this.gesture = null;
    this.assist?.end();
  }

  private get snaps(): boolean {
    return this.isSnapping !== this.ctrl;
  }

  private applySnapping(): void {
    const { snaps } = this;
    if (!this.controls) return;
    const { translate, rotate, scale } = this.steps;
    this.controls.translationSnap = snaps && this.snapTarget === 'grid' ? translate : null;
    this.controls.rotationSnap = snaps ? rotate : null;
    this.controls.scaleSnap = snaps ? scale : null;
  }

  private readonly keyChanged = (event: KeyboardEvent): void => {
    if (event.ctrlKey === this.ctrl) return;
    this.ctrl = event.ctrlKey;
    this.applySnapping();
  };
}
