import { type Group, type PerspectiveCamera, Vector3 } from 'three';
import type { CharacterController } from '../../components/CharacterController';
import type { XRRig } from '../../components/XRRig';
import type { Scene } from '../../core/Scene';
import type { XRStage } from './playInXR';
import type { XRHand } from './XRHand';
import { XRWalk } from './XRWalk';

/** Height (m) of the eyes above the floor, in scenes without an XRRig. */
const EYES = 1.6;
/** Walk settings of scenes without an XRRig (m/s, rad). */
const DEFAULTS = { speed: 2, turnStep: Math.PI / 6, teleports: true };

/** Floor of a headset's user in a scene: its XRRig, or below the camera. */
export class XRPlace {
  readonly scene: Scene;
  private readonly rig: XRRig | null;
  private readonly character: CharacterController | null;
  private readonly walk: XRWalk;

  /**
   * @param space - the floor, with the hands; it is put into the scene
   * @param camera - follows the head
   */
  constructor(
    { scene, camera: start }: XRStage,
    private readonly space: Group,
    camera: PerspectiveCamera,
  ) {
    this.scene = scene;
    this.rig = scene.componentsOf<XRRig>('XRRig').find((each) => each.isActive) ?? null;
    const object = this.rig?.gameObject;
    const { near, far } = start as PerspectiveCamera;
    Object.assign(camera, { near, far });
    space.position.set(0, 0, 0);
    space.rotation.set(0, 0, 0);
    if (!object) {
      // turns the floor to the camera's heading, and keeps it level whatever the camera's pitch
      const front = start.getWorldDirection(new Vector3());
      start.getWorldPosition(space.position).y -= EYES;
      space.rotation.y = Math.atan2(-front.x, -front.z);
    }
    (object?.object3D ?? scene.three).add(space);
    this.walk = new XRWalk(object?.object3D ?? space, scene.three, space, camera);
    this.character = (object?.getComponent('CharacterController') ?? null) as CharacterController | null;
  }

  /** Walks, turns and teleports. @param seconds - since the last frame */
  update(hands: readonly XRHand[], seconds: number): void {
    this.walk.update(hands, this.rig ?? DEFAULTS, seconds, this.character);
  }

  /** Stops a walk, and removes the floor and the hands from the scene. */
  leave(): void {
    this.character?.walk([0, 0, 0]);
    this.walk.dispose();
    this.space.removeFromParent();
  }
}
