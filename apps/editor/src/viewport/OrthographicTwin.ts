import { MathUtils, OrthographicCamera, type PerspectiveCamera } from 'three';

/** Orthographic cameras with the same view as a perspective camera at the distance of its target. */
export class OrthographicTwin {
  /** Camera to render with. Also shows what is behind the eye: near is the negative of far. */
  readonly camera = new OrthographicCamera();
  /** Camera for raycasting: same view from farther back with near at 0, since three's rays start at the eye. */
  readonly rays = new OrthographicCamera();

  /**
   * Copies the pose of the perspective camera, and the size of its view.
   * @param distance - distance from the eye (m, above 0) at which both views have the same size
   */
  follow(perspective: PerspectiveCamera, distance: number): void {
    const { camera, rays } = this;
    const top = distance * Math.tan((perspective.fov * MathUtils.DEG2RAD) / 2);
    const reach = perspective.far;
    for (const each of [camera, rays]) {
      each.top = top;
      each.bottom = -top;
      each.right = top * perspective.aspect;
      each.left = -each.right;
      each.position.copy(perspective.position);
      each.quaternion.copy(perspective.quaternion);
    }
    camera.near = -reach;
    camera.far = reach;
    rays.translateZ(reach);
    rays.near = 0;
    rays.far = 2 * reach;
    for (const each of [camera, rays]) {
      each.updateProjectionMatrix();
      each.updateMatrixWorld();
    }
  }
}
