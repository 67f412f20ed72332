import type { Camera, PerspectiveCamera, WebGLRenderer } from 'three';
import { setReversedDepth } from './reversedDepth';
import { isDepthReversed } from './state';

/** Sets the renderer's kind of depth (reversed or not) on a camera, as three does with its first draw. */
export function adoptDepth(webgl: WebGLRenderer, camera: Camera): void {
  if (!isDepthReversed(webgl) || camera.reversedDepth) return;
  setReversedDepth(camera, true);
  (camera as PerspectiveCamera).updateProjectionMatrix();
}
