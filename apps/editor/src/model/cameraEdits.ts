import { type Command, type FieldEdit, SetFields, t } from '@farol/editing';
import { Camera, GameObject, type Scene } from '@farol/engine';
import type { FieldValue } from '@farol/engine/fields';
import { Euler, Matrix4, Quaternion, Vector3 } from 'three';
import { addObject } from './edits';
import { isEvenlyScaled } from './isEvenlyScaled';

/** World position and rotation. */
export interface WorldPose {
  readonly position: Vector3;
  readonly quaternion: Quaternion;
}

/** Pose and lens of a view, for a camera of the scene. */
export interface CameraView extends WorldPose {
  /** Vertical field of view (rad). */
  readonly fov: number;
  /** Height of an orthographic view (m); null for perspective. */
  readonly size: number | null;
  /** Minimum distance of the camera's far plane (m). */
  readonly far: number;
}

const matrix = new Matrix4();
const inverse = new Matrix4();
const euler = new Euler();
const turn = new Quaternion();
const place = new Vector3();

/** Why a camera cannot be moved, in a sentence with the remedy; null when it can. */
export function poseProblem({ gameObject }: Camera): string | null {
  const { name, parent } = gameObject;
  if (gameObject.lockedInHierarchy) return t('{name} is locked: unlock it to move it.', { name });
  if (parent && !isEvenlyScaled(parent))
    return t('{name} is below {parent}, which is scaled unevenly: scale it evenly to move the camera.', {
      name,
      parent: parent.name,
    });
  return null;
}

/** Edits that give an object a world pose. Its parents must be scaled uniformly. */
export function poseEdits({ transform, object3D }: GameObject, { position, quaternion }: WorldPose): FieldEdit[] {
  const parent = object3D.parent ?? object3D;
  parent.updateWorldMatrix(true, false);
  place.copy(position).applyMatrix4(inverse.copy(parent.matrixWorld).invert());
  turn.setFromRotationMatrix(matrix.extractRotation(parent.matrixWorld)).invert().multiply(quaternion);
  const { x, y, z } = euler.setFromQuaternion(turn, 'XYZ');
  return [
    { owner: transform, name: 'position', value: place.toArray() },
    { owner: transform, name: 'rotation', value: [x, y, z] },
  ];
}

/** Lens values for the view's projection; a camera that is perspective already keeps its field of view. */
function lensOf(view: CameraView, camera: Camera | null): Record<string, FieldValue> {
  const far = Math.max((camera?.getAuthored('far') as number | undefined) ?? 200, Math.ceil(view.far));
  if (view.size !== null) return { projection: 'orthographic', size: view.size, far };
  if (camera?.projection === 'perspective') return {};
  return { projection: 'perspective', fov: view.fov };
}

/**
 * Moves a camera to a view, and gives it the view's projection: perspective or orthographic.
 * @throws Error saying why it cannot be moved
 */
export function alignCamera(camera: Camera, view: CameraView): Command {
  const problem = poseProblem(camera);
  if (problem !== null) throw new Error(problem);
  const lens = Object.entries(lensOf(view, camera)).map(([name, value]) => ({ owner: camera, name, value }));
  const edits = [...poseEdits(camera.gameObject, view), ...lens];
  return new SetFields(t('Aligned {name} to the view', { name: camera.gameObject.name }), edits);
}

/** Adds a camera that shows the current view, and selects it. @param selected - ids selected now */
export function addCameraAt(scene: Scene, name: string, view: CameraView, selected: readonly string[]): Command {
  const object = new GameObject(name);
  object.addComponent(Camera, lensOf(view, null));
  object.transform.position = view.position.toArray();
  const { x, y, z } = euler.setFromQuaternion(view.quaternion, 'XYZ');
  object.transform.rotation = [x, y, z];
  return addObject(scene, object, scene, selected);
}
