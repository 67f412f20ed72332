import type { FieldValue, Vector3Tuple } from '@farol/editing/fields';
import { Euler, type Object3D, Quaternion } from 'three';
import type { Component } from '../core/Component';
import { sizeOfField } from './TrackCurve';

/**
 * Target of clips: a field of a component, or a property of a node of a model. The value of several clips at once is
 * their weighted mean; if their weights sum to less than 1, the original value has the remaining weight.
 */
export interface Channel {
  /** Frame in which the channel last got a value. */
  frame: number;
  /** Number of bindings that may write the channel. */
  users: number;
  /** Whether the channel's component or node has left the scene, or its field has refused a value. */
  readonly isGone: boolean;
  /** Called before the first value of a frame. */
  begin(): void;
  add(values: ArrayLike<number>, weight: number): void;
  addQuaternion(values: ArrayLike<number>, weight: number): void;
  addStep(value: FieldValue, weight: number): void;
  /**
   * Writes the blended value to the target.
   * @throws FieldError when the field refuses the value; `isGone` is true then
   */
  apply(): void;
  /** Restores the value that the animated field or node had before. */
  release(): void;
}

const euler = new Euler();
const quaternion = new Quaternion();
const turned = new Float64Array(4);
const straight = new Float64Array(4);

/** Interpolates `target` towards `values` by `share` (0 to 1); at 1 the copy is exact. */
function mix(target: Float64Array, values: ArrayLike<number>, share: number): void {
  if (share === 1) for (let i = 0; i < target.length; i++) target[i] = values[i];
  else for (let i = 0; i < target.length; i++) target[i] += (values[i] - target[i]) * share;
}

function mixQuaternion(target: Float64Array, values: ArrayLike<number>, share: number): void {
  if (share === 1) mix(target, values, 1);
  else Quaternion.slerpFlat(target as never, 0, target as never, 0, values as never, 0, share);
}

function toQuaternion(angles: ArrayLike<number>, target: Float64Array): Float64Array {
  quaternion.setFromEuler(euler.set(angles[0], angles[1], angles[2], 'XYZ'));
  target[0] = quaternion.x;
  target[1] = quaternion.y;
  target[2] = quaternion.z;
  target[3] = quaternion.w;
  return target;
}

/** Channel of a component's field, written by `simulate`; a Transform's fields move the object directly. */
export class FieldChannel implements Channel {
  frame = -1;
  users = 0;
  isGone = false;
  private readonly size: 0 | 1 | 3;
  private readonly sum: Float64Array;
  private readonly turn: Float64Array | null;
  private readonly isTransform: boolean;
  private readonly isInteger: boolean;
  private readonly scene: unknown;
  private weight = 0;
  private turnWeight = 0;
  private step: FieldValue = null;
  private stepWeight = 0;

  constructor(
    readonly component: Component,
    readonly field: string,
  ) {
    const declared = component.fields[field];
    this.size = sizeOfField(declared);
    this.sum = new Float64Array(this.size);
    this.isTransform = component === component.gameObject.transform;
    this.turn = this.isTransform && field === 'rotation' ? new Float64Array(4) : null;
    this.isInteger = declared.kind === 'number' && declared.integer === true;
    this.scene = component.scene;
  }

  begin(): void {
    this.weight = this.turnWeight = this.stepWeight = 0;
  }

  add(values: ArrayLike<number>, weight: number): void {
    this.weight += weight;
    mix(this.sum, values, weight / this.weight);
  }

  addQuaternion(values: ArrayLike<number>, weight: number): void {
    this.turnWeight += weight;
    mixQuaternion(this.turn!, values, weight / this.turnWeight);
  }

  addStep(value: FieldValue, weight: number): void {
    this.weight += weight;
    // at equal weights, the value added last wins
    if (weight < this.stepWeight) return;
    this.step = value;
    this.stepWeight = weight;
  }

  apply(): void {
    const { component, field, size, sum } = this;
    if (!component.isAttached || component.scene !== this.scene) {
      this.isGone = true;
      return;
    }
    if (this.turnWeight > 0) return this.applyQuaternion();
    if (size === 0) {
      const value = this.stepWeight < 1 - this.weight ? component.getAuthored(field) : this.step;
      return this.simulate(value);
    }
    if (size === 1) {
      let value = sum[0];
      if (this.weight < 1) {
        const rest = component.getAuthored(field) as number;
        value = rest + (value - rest) * this.weight;
      }
      return this.simulate(this.isInteger ? Math.round(value) : value);
    }
    if (this.weight < 1) this.addRest(component.getAuthored(field) as Vector3Tuple);
    if (this.isTransform) return this.place(sum[0], sum[1], sum[2]);
    const shown = component.get(field) as Vector3Tuple;
    if (shown[0] === sum[0] && shown[1] === sum[1] && shown[2] === sum[2]) return;
    this.simulate([sum[0], sum[1], sum[2]]);
  }

  release(): void {
    const { component, field } = this;
    // the field may be gone: those of a surface's uniforms and of morph targets vanish with surface or model
    if (component.isAttached && Object.hasOwn(component.fields, field))
      component.simulate(field, component.getAuthored(field));
  }

  private addRest(rest: Vector3Tuple): void {
    const { sum, weight } = this;
    for (let i = 0; i < 3; i++) sum[i] = rest[i] + (sum[i] - rest[i]) * weight;
  }

  private place(x: number, y: number, z: number): void {
    const { object3D } = this.component.gameObject;
    if (this.field === 'position') object3D.position.set(x, y, z);
    else if (this.field === 'scale') object3D.scale.set(x, y, z);
    else object3D.rotation.set(x, y, z, 'XYZ');
  }

  private applyQuaternion(): void {
    const { component, weight, sum } = this;
    const turn = this.turn!;
    let total = this.turnWeight;
    if (weight > 0) {
      total += weight;
      mixQuaternion(turn, toQuaternion(sum, turned), weight / total);
    }
    if (total < 1) {
      const rest = toQuaternion(component.getAuthored('rotation') as Vector3Tuple, straight);
      mixQuaternion(turn, rest, 1 - total);
    }
    component.gameObject.object3D.quaternion.set(turn[0], turn[1], turn[2], turn[3]);
  }

  private simulate(value: FieldValue): void {
    try {
      this.component.simulate(this.field, value);
    } catch (error) {
      this.isGone = true;
      throw error;
    }
  }
}

/** Properties of a node that clips of models animate. */
export type NodeProperty = 'position' | 'quaternion' | 'scale' | 'morphTargetInfluences';

type Node = Object3D & { morphTargetInfluences?: number[] };

/** Channel of a property of a model's node, such as a bone. */
export class NodeChannel implements Channel {
  frame = -1;
  users = 0;
  readonly isGone = false;
  private readonly sum: Float64Array;
  private readonly rest: Float64Array;
  private weight = 0;

  constructor(
    readonly node: Node,
    readonly property: NodeProperty,
  ) {
    this.rest = Float64Array.from(
      property === 'morphTargetInfluences' ? (node.morphTargetInfluences ?? []) : node[property].toArray(),
    );
    this.sum = new Float64Array(this.rest.length);
  }

  begin(): void {
    this.weight = 0;
  }

  add(values: ArrayLike<number>, weight: number): void {
    this.weight += weight;
    mix(this.sum, values, weight / this.weight);
  }

  addQuaternion(values: ArrayLike<number>, weight: number): void {
    this.weight += weight;
    mixQuaternion(this.sum, values, weight / this.weight);
  }

  addStep(_value: FieldValue, _weight: number): void {}

  apply(): void {
    const { sum, rest, weight } = this;
    if (weight < 1 && this.property === 'quaternion') mixQuaternion(sum, rest, 1 - weight);
    else if (weight < 1) mix(sum, rest, 1 - weight);
    this.write(sum);
  }

  release(): void {
    this.write(this.rest);
  }

  private write(values: Float64Array): void {
    const { node, property } = this;
    if (property === 'quaternion') node.quaternion.set(values[0], values[1], values[2], values[3]);
    else if (property === 'position') node.position.set(values[0], values[1], values[2]);
    else if (property === 'scale') node.scale.set(values[0], values[1], values[2]);
    else for (let i = 0; i < values.length; i++) node.morphTargetInfluences![i] = values[i];
  }
}
