import {
  dragLabel,
  type DragStart,
  type FieldEdit,
  type Pose,
  type PoseValues,
  roundPose,
  SetFields,
  TransformDrag,
  type TransformMode,
} from '@farol/editing';
import type { Vector3Tuple } from '@farol/editing/fields';
import type { GameObject } from '@farol/engine';
import { Euler, type Object3D, Quaternion, Vector3 } from 'three';
import type { EditorDocument } from '../../model/EditorDocument';

const euler = new Euler();

/** Pose at the start of an object's drag: authored values, or, while a clip is recorded, the values at the playhead. */
function startOf({ object3D }: GameObject, values: PoseValues): DragStart {
  const parent = object3D.parent ?? object3D;
  parent.updateWorldMatrix(true, false);
  const [x, y, z] = values.rotation;
  return {
    position: new Vector3(...values.position),
    quaternion: new Quaternion().setFromEuler(euler.set(x, y, z, 'XYZ')),
    scale: new Vector3(...values.scale),
    parentWorld: parent.matrixWorld,
  };
}

/** Edits that give an object a pose, rounded to few digits. @param before - values before the drag */
function editsOf({ transform: owner }: GameObject, before: PoseValues, pose: Partial<Pose>): FieldEdit[] {
  return Object.entries(roundPose(before, pose)).map(([name, value]) => ({ owner, name, value }));
}

/** Moves objects with a proxy while it is dragged. */
export class PoseDrag {
  private readonly before: readonly PoseValues[];
  private readonly transform: TransformDrag;

  /** @param proxy - object that is dragged, in its initial pose */
  constructor(
    { commands }: EditorDocument,
    private readonly objects: readonly GameObject[],
    proxy: Object3D,
  ) {
    this.before = objects.map(({ transform }) => ({
      position: commands.valueOf(transform, 'position') as Vector3Tuple,
      rotation: commands.valueOf(transform, 'rotation') as Vector3Tuple,
      scale: commands.valueOf(transform, 'scale') as Vector3Tuple,
    }));
    this.transform = new TransformDrag(
      proxy,
      objects.map((object, i) => startOf(object, this.before[i])),
    );
  }

  /** Command that moves the objects along with the proxy to its current pose. @param options - see `TransformDrag` */
  command(mode: TransformMode, options: Parameters<TransformDrag['poses']>[1]): SetFields {
    const poses = this.transform.poses(mode, options);
    const edits = poses.flatMap((pose, i) => editsOf(this.objects[i], this.before[i], pose));
    return new SetFields(dragLabel(mode, this.objects, this.transform), edits);
  }
}
