import { type BufferGeometry, type Camera, Matrix4, type Object3D, Sphere, Vector4 } from 'three';

type Seeing = Camera & { zoom: number; isArrayCamera?: boolean };

const projectionView = new Matrix4();
const center = new Vector4();
const ORIGIN = new Sphere();

/**
 * Three's traversal of a scene for one camera of an array. Stock three traverses once for the whole array: levels of detail
 * (LOD) and the order of draws follow the array's own position and projection, so that all parts of the picture agree in both.
 */
export class ArrayTraversal {
  /** Array whose position the camera takes while the traversal runs. */
  private array: Seeing | null = null;
  private camera!: Seeing;

  /** @param seenBy - array that contains the camera; a camera outside of an array changes nothing */
  begin(camera: Camera, seenBy: Camera): void {
    if ((seenBy as Seeing).isArrayCamera !== true) return;
    projectionView.multiplyMatrices(seenBy.projectionMatrix, seenBy.matrixWorldInverse);
    this.camera = camera as Seeing;
    this.exchange((this.array = seenBy as Seeing));
  }

  /** Depth by which three sorts an object: in the clip space of the traversed array; `z` outside of an array. */
  depthOf(object: Object3D & { boundingSphere?: Sphere }, { boundingSphere }: BufferGeometry, z: number): number {
    if (this.array === null) return z;
    center.copy((object.boundingSphere ?? boundingSphere ?? ORIGIN).center as unknown as Vector4); // copying a Vector3 sets w to 1
    return center.applyMatrix4(object.matrixWorld).applyMatrix4(projectionView).z;
  }

  end(): void {
    if (this.array !== null) this.exchange(this.array);
    this.array = null;
  }

  private exchange(array: Seeing): void {
    const { matrixWorld, zoom } = this.camera;
    Object.assign(this.camera, { matrixWorld: array.matrixWorld, zoom: array.zoom });
    Object.assign(array, { matrixWorld, zoom });
  }
}
