import {
  type Camera,
  DoubleSide,
  type Intersection,
  Matrix3,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  Quaternion,
  Raycaster,
  RingGeometry,
  Vector3,
} from 'three';
import type { CharacterController } from '../../components/CharacterController';
import type { XRHand } from './XRHand';

/** Deflections (0 to 1) above which a stick turns or aims, and below which it then teleports, or may turn again. */
const PUSHED = 0.7;
const RELEASED = 0.4;
/** Farthest teleport (m), and smallest y of the unit normal of a surface that can be teleported to. */
const FARTHEST = 12;
const LEVEL = 0.7;

const UP = new Vector3(0, 1, 0);
const head = new Vector3();
const front = new Vector3();
const walkStep = new Vector3();
const place = new Vector3();
const turn = new Quaternion();
const normal = new Vector3();
const normalMatrix = new Matrix3();

/** Fields of an XRRig. */
export interface WalkSettings {
  readonly speed: number;
  readonly turnStep: number;
  readonly teleports: boolean;
}

/** Walks, turns and teleports the rig under a user of a headset. */
export class XRWalk {
  private hasTurned = false;
  private aims = false;
  private target: Vector3 | null = null;
  private readonly caster = new Raycaster();
  private readonly marker = new Mesh(
    new RingGeometry(0.2, 0.28, 32).rotateX(-Math.PI / 2),
    new MeshBasicMaterial({ color: 0x66ccff, side: DoubleSide }),
  );

  /**
   * @param rig - floor that is moved
   * @param own - objects that cannot be teleported to: hands and markers
   */
  constructor(
    private readonly rig: Object3D,
    private readonly root: Object3D,
    private readonly own: Object3D,
    private readonly camera: Camera,
  ) {}

  update(
    hands: readonly XRHand[],
    settings: WalkSettings,
    seconds: number,
    character: CharacterController | null,
  ): void {
    for (const hand of hands) {
      if (!hand.isThere) continue;
      if (hand.isLeft) this.walk(hand, settings.speed, seconds, character);
      else {
        this.turn(hand, settings.turnStep);
        if (settings.teleports) this.aim(hand, character);
      }
    }
  }

  dispose(): void {
    this.marker.removeFromParent();
    this.marker.geometry.dispose();
    this.marker.material.dispose();
  }

  /** Walks in the direction that the head faces. */
  private walk(hand: XRHand, speed: number, seconds: number, character: CharacterController | null): void {
    this.camera.getWorldDirection(front).setY(0).normalize();
    walkStep.crossVectors(front, UP).multiplyScalar(hand.right).addScaledVector(front, -hand.back).clampLength(0, 1);
    if (character) character.walk(walkStep);
    else this.move(walkStep.multiplyScalar(speed * seconds));
  }

  private turn(hand: XRHand, step: number): void {
    const side = Math.abs(hand.right);
    if (side < RELEASED) this.hasTurned = false;
    if (side < PUSHED || this.hasTurned || this.aims) return;
    this.hasTurned = true;
    // turns about the head, which may be off the rig's origin
    this.camera.getWorldPosition(head);
    this.rig.quaternion.premultiply(turn.setFromAxisAngle(UP, -Math.sign(hand.right) * step));
    this.rig.updateWorldMatrix(true, true);
    this.camera.getWorldPosition(walkStep);
    this.move(head.sub(walkStep).setY(0));
  }

  private aim(hand: XRHand, character: CharacterController | null): void {
    if (hand.back < -PUSHED) this.aims = true;
    if (!this.aims) return;
    if (hand.back < -RELEASED) {
      this.target = this.find(hand.ray);
      if (this.target === null) this.marker.removeFromParent();
      else {
        this.root.add(this.marker);
        this.marker.position.copy(this.target).y += 0.02;
        this.marker.updateMatrixWorld();
      }
      return;
    }
    this.aims = false;
    this.marker.removeFromParent();
    if (this.target === null) return;
    this.camera.getWorldPosition(head);
    this.rig.getWorldPosition(walkStep);
    head.sub(walkStep).setY(0);
    this.target.sub(head);
    if (character) character.teleport(this.target);
    else this.move(this.target.sub(walkStep));
    this.target = null;
  }

  /** First point that a ray hits, where the surface is level; otherwise null. */
  private find(ray: Object3D): Vector3 | null {
    const { caster } = this;
    caster.far = FARTHEST;
    ray.getWorldPosition(caster.ray.origin);
    ray.getWorldDirection(caster.ray.direction).negate();
    const hit = caster.intersectObject(this.root, true).find(({ object }) => this.isOfScene(object));
    return hit && isLevel(hit) ? hit.point : null;
  }

  private isOfScene(object: Object3D | null): boolean {
    for (let each = object; each !== null; each = each.parent)
      if (!each.visible || each === this.own || each === this.marker) return false;
    return true;
  }

  /** @param by - displacement in world space (m) */
  private move(by: Vector3): void {
    const { rig } = this;
    rig.getWorldPosition(place).add(by);
    rig.position.copy(rig.parent ? rig.parent.worldToLocal(place) : place);
  }
}

function isLevel({ face, object }: Intersection): boolean {
  if (!face) return false;
  normal.copy(face.normal).applyMatrix3(normalMatrix.getNormalMatrix(object.matrixWorld)).normalize();
  return Math.abs(normal.y) > LEVEL;
}
