import {
  dragLabel,
  type Gesture,
  placePivot,
  type Pose,
  roundPose,
  TransformDrag,
  type TransformMode,
} from '@farol/editing';
import { Euler, Matrix4, Object3D, type PerspectiveCamera, Quaternion, Scene, type Vector2, Vector3 } from 'three';
import { TransformControls } from 'three/addons/controls/TransformControls.js';
import type { Session } from '../model/Session';
import { type AngledPose, poseOf, SetPoses } from './SetPoses';

const middle = new Vector3();
const place = new Vector3();

/** A drag under way. */
interface Drag {
  readonly objects: readonly Object3D[];
  readonly before: readonly AngledPose[];
  readonly transform: TransformDrag;
  readonly gesture: Gesture<Object3D>;
}

/**
 * three's TransformControls, in a scene of their own, on a pivot at the centre of the selected objects. One drag is one
 * step of history.
 */
export class Gizmo {
  readonly scene = new Scene();
  private readonly controls: TransformControls;
  private readonly pivot = new Object3D();
  private current: Drag | null = null;
  private readonly end: () => void;

  constructor(private readonly session: Session) {
    this.controls = new TransformControls(session.camera);
    this.scene.add(this.pivot, this.controls.getHelper());
    this.controls.addEventListener('objectChange', () => this.preview());
    this.end = session.selection.changed.subscribe(() => this.update());
  }

  get mode(): TransformMode {
    return this.controls.mode as TransformMode;
  }

  set mode(mode: TransformMode) {
    this.controls.setMode(mode);
    this.session.edited.emit();
  }

  get space(): 'local' | 'world' {
    return this.controls.space;
  }

  set space(space: 'local' | 'world') {
    this.controls.setSpace(space);
    this.session.edited.emit();
  }

  get isDragging(): boolean {
    return this.current !== null;
  }

  /** Moves the gizmo to the selected objects, and updates its camera. @returns whether a gizmo is to be drawn */
  update(): boolean {
    const { session, controls, pivot } = this;
    controls.camera = session.camera as PerspectiveCamera;
    session.dropLost();
    if (this.isDragging) return true;
    const objects = session.topmost;
    if (objects.length === 0) {
      controls.detach();
      return false;
    }
    middle.set(0, 0, 0);
    for (const object of objects) {
      object.updateWorldMatrix(true, false);
      middle.add(place.setFromMatrixPosition(object.matrixWorld));
    }
    placePivot(pivot, middle.divideScalar(objects.length), objects.at(-1)!.matrixWorld);
    if (!controls.object) controls.attach(pivot);
    return true;
  }

  /** Highlights the handle under a point of the picture. @returns whether there is a handle */
  hover(at: Vector2): boolean {
    if (!this.update()) return false;
    // updates the handles' matrices, which may be those of the last draw
    this.controls.getHelper().updateMatrixWorld(true);
    this.controls.pointerHover(pointer(at, -1));
    return this.controls.axis !== null;
  }

  begin(at: Vector2): void {
    const { session, pivot } = this;
    const objects = session.topmost;
    const before = objects.map(poseOf);
    const starts = objects.map((object, i) => ({
      ...before[i],
      parentWorld: object.parent?.matrixWorld ?? new Matrix4(),
    }));
    this.current = { objects, before, transform: new TransformDrag(pivot, starts), gesture: session.commands.begin() };
    this.controls.pointerDown(pointer(at, 0));
  }

  drag(at: Vector2): void {
    this.controls.pointerMove(pointer(at, -1));
  }

  /** Ends a drag. @param keep - true makes a step of history; false restores the objects' poses */
  finish(at: Vector2, keep: boolean): void {
    const { current, controls } = this;
    this.current = null;
    controls.pointerUp(pointer(at, 0));
    if (keep) current?.gesture.commit();
    else current?.gesture.discard();
  }

  dispose(): void {
    this.end();
    this.controls.detach();
    this.controls.getHelper().dispose();
  }

  private preview(): void {
    if (!this.current) return;
    const { objects, before, transform, gesture } = this.current;
    const poses = transform.poses(this.mode).map((pose, i) => rounded(objects[i], before[i], pose));
    gesture.preview(new SetPoses(dragLabel(this.mode, objects, transform), objects, poses));
    this.session.edited.emit();
  }
}

/** Rounds the pose at the end of a drag, with the Euler angles nearest to the previous ones. */
function rounded({ rotation: { order } }: Object3D, before: AngledPose, pose: Partial<Pose>): Partial<AngledPose> {
  const start = { position: before.position.toArray(), rotation: before.angles, scale: before.scale.toArray() };
  const { position, rotation, scale } = roundPose(start, pose, order);
  return {
    ...(position && { position: new Vector3(...position) }),
    ...(rotation && { quaternion: new Quaternion().setFromEuler(new Euler(...rotation, order)), angles: rotation }),
    ...(scale && { scale: new Vector3(...scale) }),
  };
}

/** A pointer in the form that TransformControls expect: normalised device coordinates and a button. */
function pointer({ x, y }: Vector2, button: number): PointerEvent {
  return { x, y, button } as PointerEvent;
}
