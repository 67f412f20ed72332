import { type Camera, Group, PerspectiveCamera, Vector3 } from 'three';
import type { CharacterController } from '../../components/CharacterController';
import type { XRRig } from '../../components/XRRig';
import type { Scene } from '../../core/Scene';
import type { PictureRenderer } from '../../picture/PictureRenderer';
import { XRGrab } from './XRGrab';
import { XRHand } from './XRHand';
import { XRWalk } from './XRWalk';

/** Modes of a WebXR session: in a scene of its own, or laid over the room. */
export type XRMode = 'immersive-vr' | 'immersive-ar';

/** Scene of an XR session, and the control of the page's own frames. */
export interface XRStage {
  readonly picture: PictureRenderer;
  readonly scene: Scene;
  /** Camera whose pose the session starts from, in scenes without an XRRig. */
  readonly camera: Camera;
  /** Advances the scene. @param seconds - since the last frame, 0.1 at most */
  advance(seconds: number): unknown;
  /** Stops the page's own frames while the session draws. */
  pause(): unknown;
  /** Resumes the page's own frames. */
  resume(): unknown;
}

/** Height (m) of the eyes above the floor, in scenes without an XRRig. */
const EYES = 1.6;
const LONGEST_STEP = 0.1;
/** Walk settings of scenes without an XRRig (m/s, rad). */
const DEFAULTS = { speed: 2, turnStep: Math.PI / 6, teleports: true };

/** Session modes that the device supports and the page may use. */
export async function xrModes(): Promise<XRMode[]> {
  // Chromium logs an error when a page queries WebXR and its permissions policy forbids it
  const { featurePolicy } = document as { featurePolicy?: { allowsFeature(name: string): boolean } };
  const xr = featurePolicy?.allowsFeature('xr-spatial-tracking') === false ? undefined : navigator.xr;
  const modes: XRMode[] = ['immersive-vr', 'immersive-ar'];
  const has = await Promise.all(modes.map((mode) => xr?.isSessionSupported(mode).catch(() => false) ?? false));
  return modes.filter((_, i) => has[i]);
}

/**
 * Shows a scene in a headset until the session ends. The floor is the scene's XRRig, or else lies below the camera; the
 * hands walk, turn, teleport and hold Grabbables. Call it from a click.
 * @returns the session, once it presents
 * @throws Error (as a rejection) where the user or the device refuses
 */
export async function playInXR(stage: XRStage, mode: XRMode): Promise<XRSession> {
  const { farol } = stage.picture;
  const { webgl } = farol;
  const { xr } = webgl;
  const session = await navigator.xr!.requestSession(mode, {
    requiredFeatures: ['local-floor'],
    optionalFeatures: ['hand-tracking', 'layers'],
  });
  stage.pause();
  const { scene } = stage;
  const rig = scene.componentsOf<XRRig>('XRRig').find((each) => each.isActive) ?? null;
  const space = new Group();
  const camera = new PerspectiveCamera();
  const { near, far } = stage.camera as PerspectiveCamera;
  Object.assign(camera, { near, far });
  space.add(camera);
  if (rig) rig.gameObject.object3D.add(space);
  else standAt(space, stage.camera, scene);
  const hands = [0, 1].map((i) => new XRHand(xr, i, space));
  const grabs = hands.map((hand) => new XRGrab(hand));
  const walk = new XRWalk(rig?.gameObject.object3D ?? space, scene.three, space, camera);
  const character = (rig?.gameObject.getComponent('CharacterController') ?? null) as CharacterController | null;
  let last = 0;
  const frame = (now: number): void => {
    const seconds = last === 0 ? 0 : Math.min((now - last) / 1000, LONGEST_STEP);
    last = now;
    space.updateWorldMatrix(true, true);
    walk.update(hands, rig ?? DEFAULTS, seconds, character);
    for (const grab of grabs) grab.update(scene, seconds, grabs);
    stage.advance(seconds);
    stage.picture.render(scene, camera);
  };
  const end = (): void => {
    webgl.setAnimationLoop(null);
    xr.enabled = stage.picture.inXR = false;
    character?.walk([0, 0, 0]);
    for (const hand of hands) hand.dispose();
    walk.dispose();
    space.removeFromParent();
    stage.resume();
  };
  xr.addEventListener('sessionend', function ended() {
    xr.removeEventListener('sessionend', ended);
    end();
  });
  xr.enabled = stage.picture.inXR = true;
  webgl.setAnimationLoop(frame);
  await xr.setSession(session);
  return session;
}

/** Puts `space`, the floor, below a camera of the scene: upright, with the camera's heading. */
function standAt(space: Group, camera: Camera, scene: Scene): void {
  const front = camera.getWorldDirection(new Vector3());
  camera.getWorldPosition(space.position).y -= EYES;
  space.rotation.y = Math.atan2(-front.x, -front.z);
  scene.three.add(space);
}
