import { HemisphereLight, Vector3 } from 'three';

const top = new Vector3();

/**
 * A hemisphere light whose sky is at the top (+Y) of its parent. three takes the direction of the sky from the light's
 * world position, so the position in the world matrix is set to that direction.
 */
export class SkyLight extends HemisphereLight {
  override updateMatrixWorld(force?: boolean): void {
    super.updateMatrixWorld(force);
    top.setFromMatrixColumn(this.parent ? this.parent.matrixWorld : this.matrixWorld, 1).normalize();
    this.matrixWorld.setPosition(top);
  }
}
