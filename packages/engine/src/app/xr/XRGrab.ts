import { Box3, Matrix4, type Object3D, Quaternion, Raycaster, Vector3 } from 'three';
import type { Grabbable } from '../../components/Grabbable';
import type { RigidBody } from '../../components/RigidBody';
import type { GameObject } from '../../core/GameObject';
import type { Scene } from '../../core/Scene';
import type { XRHand } from './XRHand';

const box = new Box3();
const hand = new Vector3();
const matrix = new Matrix4();
const place = new Vector3();
const turn = new Quaternion();
const scale = new Vector3();

/** Grabs, carries and releases Grabbables of a scene with one hand. */
export class XRGrab {
  /** Object that is held; null for none. */
  held: GameObject | null = null;
  private did = false;
  /** Pose of the held object in the grip's space. */
  private readonly offset = new Matrix4();
  private readonly last = new Vector3();
  private readonly velocity = new Vector3();
  private readonly caster = new Raycaster();

  constructor(private readonly hand: XRHand) {}

  /** Grabs, carries or releases an object. @param others - all hands; this one may take an object from another hand */
  update(scene: Scene, seconds: number, others: readonly XRGrab[]): void {
    const { isHolding } = this.hand;
    if (isHolding && !this.did) this.grab(scene, others);
    else if (!isHolding && this.held) this.letGo();
    this.did = isHolding;
    if (this.held?.scene !== scene) this.held = null;
    if (this.held) this.carry(this.held, seconds);
  }

  private grab(scene: Scene, others: readonly XRGrab[]): void {
    const held = this.find(scene);
    if (!held) return;
    for (const other of others) if (other.held === held) other.held = null;
    this.held = held;
    held.object3D.updateWorldMatrix(true, false);
    this.offset.copy(this.hand.grip.matrixWorld).invert().multiply(held.object3D.matrixWorld);
    this.last.setFromMatrixPosition(held.object3D.matrixWorld);
    this.velocity.set(0, 0, 0);
  }

  private letGo(): void {
    const body = this.held?.getComponent('RigidBody') as RigidBody | null;
    if (body) body.velocity = this.velocity;
    this.held = null;
  }

  private carry(held: GameObject, seconds: number): void {
    const { object3D } = held;
    matrix.multiplyMatrices(this.hand.grip.matrixWorld, this.offset).decompose(place, turn, scale);
    if (seconds > 0) this.velocity.subVectors(place, this.last).divideScalar(seconds);
    this.last.copy(place);
    const body = held.getComponent('RigidBody') as RigidBody | null;
    if (body) {
      body.teleport(place, turn);
      body.velocity = this.velocity;
    }
    if (object3D.parent) matrix.premultiply(inverseOf(object3D.parent));
    matrix.decompose(object3D.position, object3D.quaternion, scale);
  }

  /** The Grabbable nearest to the hand within its reach, else the first one that its ray hits. */
  private find(scene: Scene): GameObject | null {
    this.hand.grip.getWorldPosition(hand);
    let nearest = Infinity;
    let found: GameObject | null = null;
    const all = scene.componentsOf<Grabbable>('Grabbable').filter((each) => each.isActive);
    for (const { gameObject, reach } of all) {
      const distance = box.setFromObject(gameObject.object3D).distanceToPoint(hand);
      if (distance <= Math.min(reach, nearest)) [nearest, found] = [distance, gameObject];
    }
    if (found) return found;
    const { caster } = this;
    this.hand.ray.getWorldPosition(caster.ray.origin);
    this.hand.ray.getWorldDirection(caster.ray.direction).negate();
    for (const { gameObject, far } of all) {
      const hit = far ? caster.intersectObject(gameObject.object3D, true).at(0) : undefined;
      if (hit && hit.distance < nearest) [nearest, found] = [hit.distance, gameObject];
    }
    return found;
  }
}

const inverse = new Matrix4();
const inverseOf = (object: Object3D): Matrix4 => inverse.copy(object.matrixWorld).invert();
