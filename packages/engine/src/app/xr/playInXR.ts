import { type Camera, Group, PerspectiveCamera } from 'three';
import type { Scene } from '../../core/Scene';
import type { PictureRenderer } from '../../picture/PictureRenderer';
import { XRGrab } from './XRGrab';
import { XRHand } from './XRHand';
import { XRPlace } from './XRPlace';

/** Modes of a WebXR session: the scene alone is seen (VR), or it is drawn over the real room (AR). */
export type XRMode = 'immersive-vr' | 'immersive-ar';

/** Scene of an XR session, and the control of the page's own frames. */
export interface XRStage {
  readonly picture: PictureRenderer;
  /** The scene that is shown; another one may take its place while the session lasts. */
  readonly scene: Scene;
  /** Camera at whose pose the user stands when a scene without an XRRig is entered. */
  readonly camera: Camera;
  /** Advances the scene. @param seconds - since the last frame, 0.1 at most */
  advance(seconds: number): unknown;
  /** Stops the page's own frames while the session draws. */
  pause(): unknown;
  /** Resumes the page's own frames. */
  resume(): unknown;
}

const LONGEST_STEP = 0.1;
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
 * hands walk, turn, teleport and hold Grabbables. Call it in the handler of a click.
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
  const space = new Group();
  const camera = new PerspectiveCamera();
  space.add(camera);
  const hands = [0, 1].map((i) => new XRHand(xr, i, space));
  const grabs = hands.map((hand) => new XRGrab(hand));
  let place = new XRPlace(stage, space, camera);
  let last = 0;
  const frame = (now: number): void => {
    const seconds = last === 0 ? 0 : Math.min((now - last) / 1000, LONGEST_STEP);
    last = now;
    if (place.scene !== stage.scene) {
      place.leave();
      place = new XRPlace(stage, space, camera);
    }
    space.updateWorldMatrix(true, true);
    place.update(hands, seconds);
    for (const grab of grabs) grab.update(place.scene, seconds, grabs);
    stage.advance(seconds);
    stage.picture.render(place.scene, camera);
  };
  const end = (): void => {
    webgl.setAnimationLoop(null);
    xr.enabled = stage.picture.inXR = false;
    for (const hand of hands) hand.dispose();
    place.leave();
    stage.resume();
  };
  xr.addEventListener('sessionend', function ended() {
    xr.removeEventListener('sessionend', ended);
    end();
  });
  xr.enabled = stage.picture.inXR = true;
  webgl.setAnimationLoop(frame);
  try {
    await xr.setSession(session);
  } catch (error) {
    await session.end();
    throw error;
  }
  return session;
}
