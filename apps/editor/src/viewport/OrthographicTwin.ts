import { MathUtils, OrthographicCamera, type PerspectiveCamera } from 'three';

/** A picture without perspective that shows as much as a perspective one does at the distance of its target. */
export class OrthographicTwin {
  /** To draw with. What is behind the eye is seen too: its near plane is as far behind as its far plane is before. */
  readonly camera = new OrthographicCamera();
  /** Sees the same from farther back, its near plane at 0: rays of three's begin at the eye. */
  readonly rays = new OrthographicCamera();

  /**
   * Takes over place and size.
   * @param distance - from the eye to what is as large in both pictures (m, above 0)
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
