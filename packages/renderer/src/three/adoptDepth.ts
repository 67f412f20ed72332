import type { Camera, PerspectiveCamera, WebGLRenderer } from 'three';
import { setReversedDepth } from './reversedDepth';
import { isDepthReversed } from './state';

/** Gives a camera the renderer's way to store depth, as three does where it first draws with it. */
export function adoptDepth(webgl: WebGLRenderer, camera: Camera): void {
  if (!isDepthReversed(webgl) || camera.reversedDepth) return;
  setReversedDepth(camera, true);
  (camera as PerspectiveCamera).updateProjectionMatrix();
}
