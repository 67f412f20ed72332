import { checkFieldValue, euler, FieldError, type FieldValue, vector3, type Vector3Tuple } from '@farol/editing/fields';
import { Euler, Matrix4, type Object3D, Quaternion, Vector3 } from 'three';
import { component } from './Component';
import { toVector3, type Vector3Input } from './toVector3';

const matrix = new Matrix4();
const parentInverse = new Matrix4();
const quaternion = new Quaternion();
const parentQuaternion = new Quaternion();
const turned = new Euler();
const position = new Vector3();
const scale = new Vector3();
const UP: Vector3Tuple = [0, 1, 0];

/**
 * Position, rotation and scale of a GameObject, which has exactly one. The fields are relative to the parent; `get`
 * gives the present values, `getAuthored` those before simulation moved the object. Its methods are edits: they change
 * the authored values. Front is the object's -Z axis, as for three's cameras and spot lights.
 */
export class Transform extends component({
  position: vector3([0, 0, 0], { unit: 'm', step: 0.1, help: 'Position relative to the parent.' }),
  rotation: euler([0, 0, 0], { help: 'Rotation about x, then y, then z, within the parent.' }),
  scale: vector3([1, 1, 1], { step: 0.1, help: 'Scale along its own axes.' }),
}) {
  static override readonly typeName: string = 'Transform';
  static override readonly icon: string = 'transform';
  static override readonly unique: boolean = true;
  static override readonly help: string = 'Position, rotation and scale.';

  override get(name: string): FieldValue {
    if (!this.isAttached) return super.get(name);
    const { object3D } = this.gameObject;
    if (name === 'position') return object3D.position.toArray();
    if (name === 'rotation') return [object3D.rotation.x, object3D.rotation.y, object3D.rotation.z];
    if (name === 'scale') return object3D.scale.toArray();
    return super.get(name);
  }

  /** Moves the object for the simulation; the authored values stay. */
  override simulate(name: string, value: FieldValue): void {
    const problem = checkFieldValue(this.fields[name], value);
    if (problem) throw new FieldError(this.ownerName, name, problem);
    if (this.isAttached) place(this.gameObject.object3D, name, value as Vector3Tuple);
  }

  override endSimulation(): void {
    if (this.isAttached) this.restoreAuthored();
  }

  override onAttach(): void {
    this.restoreAuthored();
  }

  override onFieldChanged(name: string): void {
    restore(this, name);
  }

  /** Moves the object back to its authored pose, undoing simulation. */
  restoreAuthored(): void {
    restore(this, 'position');
    restore(this, 'rotation');
    restore(this, 'scale');
  }

  /** The matrix from the object's space to the world's: a copy, up to date. */
  get modelMatrix(): Matrix4 {
    const { object3D } = this.gameObject;
    object3D.updateWorldMatrix(true, false);
    return object3D.matrixWorld.clone();
  }

  set modelMatrix(value: Matrix4) {
    const { parent } = this.gameObject.object3D;
    matrix.copy(value);
    if (parent) {
      parent.updateWorldMatrix(true, false);
      matrix.premultiply(parentInverse.copy(parent.matrixWorld).invert());
    }
    matrix.decompose(position, quaternion, scale);
    this.set('position', position.toArray());
    this.setQuaternion(quaternion);
    this.set('scale', scale.toArray());
  }

  /** Unit vector to the object's right (+X) in the world. */
  get right(): Vector3 {
    return axisOf(this, 0, 1);
  }

  /** Unit vector to the object's top (+Y) in the world. */
  get top(): Vector3 {
    return axisOf(this, 1, 1);
  }

  /** Unit vector to the object's front (-Z) in the world. */
  get front(): Vector3 {
    return axisOf(this, 2, -1);
  }

  /** World position (m). */
  get worldPosition(): Vector3 {
    return new Vector3().setFromMatrixPosition(this.modelMatrix);
  }

  /** Moves by a vector along the axes of the world, in metres. */
  translate(offset: Vector3Input): void {
    const { object3D } = this.gameObject;
    const world = this.worldPosition.add(toVector3(offset, position));
    if (object3D.parent) object3D.parent.worldToLocal(world);
    this.set('position', world.toArray());
  }

  /** Moves by a vector along the object's own axes, in metres of its parent's space (its own scale is ignored). */
  translateLocal(offset: Vector3Input): void {
    const { object3D } = this.gameObject;
    this.set(
      'position',
      toVector3(offset, position).applyQuaternion(object3D.quaternion).add(object3D.position).toArray(),
    );
  }

  /**
   * Turns about a world axis through the object's origin, by radians, anticlockwise when the axis points at the viewer.
   */
  rotate(radians: number, axis: Vector3Input): void {
    const { object3D } = this.gameObject;
    const inverse = parentRotation(object3D, parentQuaternion).invert();
    toVector3(axis, position).normalize().applyQuaternion(inverse);
    this.setQuaternion(quaternion.setFromAxisAngle(position, radians).multiply(object3D.quaternion));
  }

  /** Turns about one of the object's own axes, by radians. */
  rotateLocal(radians: number, axis: Vector3Input): void {
    quaternion.setFromAxisAngle(toVector3(axis, position).normalize(), radians);
    this.setQuaternion(quaternion.premultiply(this.gameObject.object3D.quaternion));
  }

  /** Turns the front to a point of the world. */
  lookAt(target: Vector3Input): void;
  /**
   * Moves the object to `eye` (world space) and turns its front to `target`.
   * @param up - direction that the top (+Y) turns towards; [0, 1, 0] when absent
   */
  lookAt(eye: Vector3Input, target: Vector3Input, up?: Vector3Input): void;
  lookAt(first: Vector3Input, second?: Vector3Input, up: Vector3Input = UP): void {
    const { object3D } = this.gameObject;
    const target = toVector3(second ?? first, new Vector3());
    const eye = second ? toVector3(first, new Vector3()) : this.worldPosition;
    matrix.lookAt(eye, target, toVector3(up, position));
    const inverse = parentRotation(object3D, parentQuaternion).invert();
    if (second) {
      if (object3D.parent) object3D.parent.worldToLocal(eye);
      this.set('position', eye.toArray());
    }
    this.setQuaternion(quaternion.setFromRotationMatrix(matrix).premultiply(inverse));
  }

  /** Sets the rotation from a quaternion relative to the parent. */
  setQuaternion(value: Quaternion): void {
    turned.setFromQuaternion(value, 'XYZ');
    this.set('rotation', [turned.x, turned.y, turned.z]);
  }
}

/** Sets a property of the object3D to the authored value of the Transform's field. */
function restore(transform: Transform, name: string): void {
  place(transform.gameObject.object3D, name, transform.getAuthored(name) as Vector3Tuple);
}

function place(object3D: Object3D, name: string, [x, y, z]: Vector3Tuple): void {
  if (name === 'position') object3D.position.set(x, y, z);
  else if (name === 'rotation') object3D.rotation.set(x, y, z, 'XYZ');
  else if (name === 'scale') object3D.scale.set(x, y, z);
}

/** A column of the model matrix as a unit vector, times a sign. */
const axisOf = (transform: Transform, column: number, sign: number): Vector3 =>
  new Vector3().setFromMatrixColumn(transform.modelMatrix, column).normalize().multiplyScalar(sign);

/** The rotation of an object's parent in the world. */
function parentRotation({ parent }: Object3D, target: Quaternion): Quaternion {
  if (!parent) return target.identity();
  parent.updateWorldMatrix(true, false);
  return target.setFromRotationMatrix(matrixRotation(parent.matrixWorld));
}

const rotation = new Matrix4();
const matrixRotation = (world: Matrix4): Matrix4 => rotation.extractRotation(world);
