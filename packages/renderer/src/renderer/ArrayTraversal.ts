import { type ArrayCamera, type BufferGeometry, type Camera, Matrix4, type Mesh, Vector4 } from 'three';

type Zooming = Camera & { zoom: number };

const center = new Vector4();

/**
 * Three's traversal of a scene for one camera of an array. Stock three traverses once for the whole array: levels of detail
 * (LOD) and the order of draws go by the array's own place and projection, so that they are the same in all of its parts.
 */
export class ArrayTraversal {
  private readonly projectionView = new Matrix4();
  private readonly place = new Matrix4();
  private zoom = 1;
  private camera: Zooming | null = null;

  /** Whether the traversal that runs is that of an array. */
  get runs(): boolean {
    return this.camera !== null;
  }

  /**
   * Lends the camera the array's place, by which LODs choose their level, until `end`.
   * @param seenBy - array that contains the camera, or the camera itself: then nothing is done
   */
  begin(camera: Camera, seenBy: Camera): void {
    if ((seenBy as ArrayCamera).isArrayCamera !== true) return;
    this.camera = camera as Zooming;
    this.place.copy(camera.matrixWorld);
    this.zoom = this.camera.zoom;
    camera.matrixWorld.copy(seenBy.matrixWorld);
    this.camera.zoom = (seenBy as Zooming).zoom;
    this.projectionView.multiplyMatrices(seenBy.projectionMatrix, seenBy.matrixWorldInverse);
  }

  end(): void {
    if (this.camera === null) return;
    this.camera.matrixWorld.copy(this.place);
    this.camera.zoom = this.zoom;
    this.camera = null;
  }

  /** Depth by which three sorts an object: of its bounding sphere's centre in the array's clip space. */
  depthOf(object: Mesh & { isSprite?: boolean }, geometry: BufferGeometry): number {
    if (object.isSprite === true) center.setFromMatrixPosition(object.matrixWorld);
    else {
      // three has computed both, for its frustum or its own depth
      const sphere = (object as { boundingSphere?: typeof geometry.boundingSphere }).boundingSphere;
      center.copy((sphere ?? geometry.boundingSphere)!.center as unknown as Vector4).applyMatrix4(object.matrixWorld);
    }
    return center.applyMatrix4(this.projectionView).z;
  }
}
