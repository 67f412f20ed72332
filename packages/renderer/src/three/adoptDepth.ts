import type { Camera, PerspectiveCamera, WebGLRenderer } from 'three';

/** Gives a camera the renderer's way to store depth, as three does where it first draws with it. */
export function adoptDepth(webgl: WebGLRenderer, camera: Camera): void {
  if (!webgl.state.buffers.depth.getReversed() || camera.reversedDepth) return;
  const own = camera as PerspectiveCamera & { _reversedDepth: boolean };
  own._reversedDepth = true;
  own.updateProjectionMatrix();
}
