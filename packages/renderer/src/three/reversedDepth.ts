import type { Camera } from 'three';

/** Private property that `Camera.reversedDepth` reads. */
interface DepthOfCamera {
  _reversedDepth: boolean;
}

/** Sets whether depths of a camera's projection are reversed, from its next `updateProjectionMatrix` on. */
export function setReversedDepth(camera: Camera, reversed: boolean): void {
  (camera as unknown as DepthOfCamera)._reversedDepth = reversed;
}
