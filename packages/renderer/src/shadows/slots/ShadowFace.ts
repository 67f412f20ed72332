import { Frustum, Matrix4, PerspectiveCamera, Vector3, WebGLCoordinateSystem, type Camera } from 'three';
import type { Caster } from '../casters/Caster';
import { TriangleRuns } from '../casters/merged/TriangleRuns';

const frustum = new Frustum();
const whole = new Matrix4();
const right = new Vector3();
const up = new Vector3();
const back = new Vector3();

/** One face of a shadow map: its camera, and the casters that the camera draws. */
export class ShadowFace {
  private readonly facePlanes = new Float64Array(24);
  private readonly partPlanes = new Float64Array(24);
  private hasFacePlanes = false;
  private hasPartPlanes = false;
  /** The casters that are drawn one by one in this frame. */
  readonly casters: Caster[] = [];
  private readonly merged: (TriangleRuns | undefined)[] = [];
  /** Transform from world to clip space, by which visible receivers are found. */
  readonly matrix = new Matrix4();
  /** The part of the face that receivers in the camera's view sample (texels of the face). */
  readonly visible = { left: 0, bottom: 0, right: 0, top: 0 };
  /** The part of the face that is drawn (texels of the face). */
  readonly drawn = { left: 0, bottom: 0, right: 0, top: 0 };
  /**
   * Arguments that the camera's projection was last made with: near, far, widening, and 1 for reversed depth; for faces
   * of a cube.
   */
  readonly aim = new Float64Array(4);
  /** Left edge of the face in the atlas, its border included (texels). */
  x = 0;
  y = 0;
  width = 0;
  height = 0;

  constructor(readonly camera: Camera) {}

  /** Frustum planes of the face (world space), 6 × 4 numbers from `viewFrustumPlanes`. */
  get planes(): Float64Array {
    if (!this.hasFacePlanes) this.findPlanes();
    return this.facePlanes;
  }

  /** Frustum planes of the drawn part of the face (world space). */
  get drawnPlanes(): Float64Array {
    if (!this.hasPartPlanes) {
      this.hasPartPlanes = true;
      this.partPlanes.set(this.planes);
      const { left, bottom, right, top } = this.drawn;
      const isAll = left === 0 && bottom === 0 && right === this.width && top === this.height;
      if (!isAll && this.texels > 0) this.narrowPlanes();
    }
    return this.partPlanes;
  }

  /** Triangles to draw from a page of merged casters, for casters that are drawn with one `Side` of three's. */
  runs(page: number, side: number): TriangleRuns {
    return (this.merged[page * 3 + side] ??= new TriangleRuns());
  }

  /** Whether the drawn part holds the visible part of the face. */
  get isCovered(): boolean {
    const { visible, drawn } = this;
    if (visible.left >= visible.right || visible.bottom >= visible.top) return true;
    const across = visible.left >= drawn.left && visible.right <= drawn.right;
    return across && visible.bottom >= drawn.bottom && visible.top <= drawn.top;
  }

  /** Number of texels in the drawn part. */
  get texels(): number {
    const { left, bottom, right, top } = this.drawn;
    return Math.max(0, right - left) * Math.max(0, top - bottom);
  }

  /** Plans to draw all of the face, or only the visible part. */
  plan(isPartial: boolean): void {
    const { drawn, visible } = this;
    drawn.left = isPartial ? visible.left : 0;
    drawn.bottom = isPartial ? visible.bottom : 0;
    drawn.right = isPartial ? visible.right : this.width;
    drawn.top = isPartial ? visible.top : this.height;
    this.hasPartPlanes = false;
  }

  /** Replaces the four side planes by those of the drawn part. */
  private narrowPlanes(): void {
    const { camera, drawn, width, height, partPlanes } = this;
    const e = whole.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse).elements;
    for (let i = 0; i < 4; i++) {
      // a point is within where side * (x - bound * w) >= 0, in clip space
      const side = i & 1 ? -1 : 1;
      const row = i >> 1;
      const texel = row === 0 ? (i & 1 ? drawn.right : drawn.left) : i & 1 ? drawn.top : drawn.bottom;
      const bound = (texel / (row === 0 ? width : height)) * 2 - 1;
      const a = side * (e[row] - bound * e[3]);
      const b = side * (e[row + 4] - bound * e[7]);
      const c = side * (e[row + 8] - bound * e[11]);
      const scale = 1 / Math.sqrt(a * a + b * b + c * c);
      partPlanes[i * 4] = a * scale;
      partPlanes[i * 4 + 1] = b * scale;
      partPlanes[i * 4 + 2] = c * scale;
      partPlanes[i * 4 + 3] = side * (e[row + 12] - bound * e[15]) * scale;
    }
  }

  /** Empties the lists of casters. */
  clear(): void {
    this.casters.length = 0;
    for (const runs of this.merged) runs?.clear();
  }

  /** Recomputes planes and matrix. Call when the camera's matrices have changed. */
  update(): void {
    this.hasFacePlanes = this.hasPartPlanes = false;
  }

  private findPlanes(): void {
    const { camera, facePlanes: planes } = this;
    this.hasFacePlanes = true;
    whole.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    frustum.setFromProjectionMatrix(whole, WebGLCoordinateSystem, camera.reversedDepth);
    for (let i = 0; i < 6; i++) {
      const { normal, constant } = frustum.planes[i];
      planes[i * 4] = normal.x;
      planes[i * 4 + 1] = normal.y;
      planes[i * 4 + 2] = normal.z;
      planes[i * 4 + 3] = constant;
    }
  }
}

/**
 * Direction and up of the camera of each face of a cube, +x, -x, +y, -y, +z, -z, as farol_cubeFace in lightShadow.glsl
 * has them.
 */
const AXES = [
  [1, 0, 0, 0, 1, 0],
  [-1, 0, 0, 0, 1, 0],
  [0, 1, 0, 0, 0, 1],
  [0, -1, 0, 0, 0, 1],
  [0, 0, 1, 0, 1, 0],
  [0, 0, -1, 0, 1, 0],
] as const;

/** Makes the six faces of a cube map, which `aimCubeFace` turns. */
export function makeCubeFaces(): ShadowFace[] {
  return AXES.map(() => {
    const camera = new PerspectiveCamera(90, 1, 0.5, 500);
    camera.matrixAutoUpdate = camera.matrixWorldAutoUpdate = false;
    return new ShadowFace(camera);
  });
}

/**
 * Turns the camera of one face of a cube map.
 * @param index - index of the face, 0 to 5
 * @param position - position of the light (world space, m)
 * @param widening - tangent of half the camera's angle: 1 for the face alone, more to include its border
 */
export function aimCubeFace(
  face: ShadowFace,
  index: number,
  position: Vector3,
  near: number,
  far: number,
  widening: number,
): void {
  const camera = face.camera as PerspectiveCamera;
  const axes = AXES[index];
  back.set(-axes[0], -axes[1], -axes[2]);
  up.set(axes[3], axes[4], axes[5]);
  right.crossVectors(up, back);
  const { matrixWorld, matrixWorldInverse, projectionMatrix, projectionMatrixInverse, reversedDepth } = camera;
  matrixWorld.makeBasis(right, up, back);
  matrixWorldInverse.copy(matrixWorld).transpose();
  matrixWorldInverse.setPosition(-right.dot(position), -up.dot(position), -back.dot(position));
  matrixWorld.setPosition(position);
  face.update();
  const { aim } = face;
  if (aim[0] === near && aim[1] === far && aim[2] === widening && aim[3] === +reversedDepth) return;
  aim[0] = near;
  aim[1] = far;
  aim[2] = widening;
  aim[3] = +reversedDepth;
  camera.near = near;
  camera.far = far;
  const side = near * widening;
  projectionMatrix.makePerspective(-side, side, side, -side, near, far, WebGLCoordinateSystem, reversedDepth);
  projectionMatrixInverse.copy(projectionMatrix).invert();
}
