import { Matrix4, type Object3D, Quaternion, Vector3 } from 'three';

/** Kinds of drags of a gizmo. */
export type TransformMode = 'translate' | 'rotate' | 'scale';

/** Options of a gizmo drag of several objects. */
export interface DragOptions {
  /** Whether each object rotates and scales about its own origin, not about the pivot. */
  readonly each?: boolean;
  /** Whether objects that move also rotate with the pivot. */
  readonly turns?: boolean;
}

/** Position, rotation and scale of an object relative to its parent. */
export interface Pose {
  readonly position: Vector3;
  readonly quaternion: Quaternion;
  readonly scale: Vector3;
}

/** Pose of an object when a drag begins, with its parent's world matrix. */
export interface DragStart extends Pose {
  readonly parentWorld: Matrix4;
}

interface Start extends Pose {
  readonly world: Matrix4;
  readonly worldToParent: Matrix4;
  readonly worldRotation: Quaternion;
  readonly parentRotation: Quaternion;
}

const delta = new Matrix4();
const turn = new Quaternion();

/**
 * Poses of objects while a gizmo drags a pivot: the objects move, rotate and scale with the pivot. A single object
 * rotates and scales about its own origin; several about the pivot, or each about its own origin.
 */
export class TransformDrag {
  private readonly starts: readonly Start[];
  private readonly pivotStart: Vector3;
  private readonly pivotInverse: Matrix4;
  private readonly pivotRotationInverse: Quaternion;

  /**
   * @param pivot - object that the gizmo moves, below parents at the origin without scale; its world matrix is up to
   * date
   */
  constructor(
    private readonly pivot: Object3D,
    starts: readonly DragStart[],
  ) {
    this.pivotStart = pivot.position.clone();
    this.pivotInverse = pivot.matrixWorld.clone().invert();
    this.pivotRotationInverse = pivot.quaternion.clone().invert();
    this.starts = starts.map(({ position, quaternion, scale, parentWorld }) => {
      const parentRotation = new Quaternion().setFromRotationMatrix(new Matrix4().extractRotation(parentWorld));
      return {
        ...{ position, quaternion, scale, parentRotation },
        world: new Matrix4().compose(position, quaternion, scale).premultiply(parentWorld),
        worldToParent: parentWorld.clone().invert(),
        worldRotation: parentRotation.clone().multiply(quaternion),
      };
    });
  }

  /** Displacement of the pivot (m, world space). */
  get offset(): Vector3 {
    return this.pivot.position.clone().sub(this.pivotStart);
  }

  /** Rotation of the pivot (rad), -π to π: positive is counterclockwise about the nearest axis. */
  get angle(): number {
    const { x, y, z, w } = turn.copy(this.pivot.quaternion).multiply(this.pivotRotationInverse);
    const largest = [x, y, z].reduce((found, each) => (Math.abs(each) > Math.abs(found) ? each : found), 0);
    const angle = 2 * Math.atan2(Math.hypot(x, y, z), Math.abs(w));
    return angle * Math.sign(largest) * (w < 0 ? -1 : 1);
  }

  /** Scale factors of the pivot along its own axes. */
  get factors(): Vector3 {
    return this.pivot.scale.clone();
  }

  /**
   * Poses for the pivot's present pose, in the order of the starts; parts that the mode does not change are omitted.
   */
  poses(mode: TransformMode, { each = false, turns = false }: DragOptions = {}): Partial<Pose>[] {
    const { pivot, starts } = this;
    pivot.updateMatrixWorld();
    delta.copy(pivot.matrixWorld).multiply(this.pivotInverse);
    turn.copy(pivot.quaternion).multiply(this.pivotRotationInverse);
    return starts.map(({ world, worldToParent, worldRotation, parentRotation, scale }) => ({
      ...((mode === 'translate' || (starts.length > 1 && !each)) && {
        position: new Vector3().setFromMatrixPosition(world).applyMatrix4(delta).applyMatrix4(worldToParent),
      }),
      ...((mode === 'rotate' || (mode === 'translate' && turns)) && {
        quaternion: parentRotation.clone().invert().multiply(turn).multiply(worldRotation),
      }),
      ...(mode === 'scale' && { scale: scale.clone().multiply(pivot.scale) }),
    }));
  }
}

const matrix = new Matrix4();

/**
 * Places a gizmo's pivot in the world, with an object's rotation.
 * @param like - world matrix of the object
 */
export function placePivot(pivot: Object3D, place: Vector3, like: Matrix4): void {
  pivot.position.copy(place);
  pivot.quaternion.setFromRotationMatrix(matrix.extractRotation(like));
  pivot.scale.set(1, 1, 1);
  pivot.updateMatrixWorld();
}
