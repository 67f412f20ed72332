import { Frustum, Matrix4, PerspectiveCamera, Vector3, WebGLCoordinateSystem, type Camera } from 'three';
import { TriangleRuns } from '../casters/merged/TriangleRuns';
import type { Caster } from '../casters/ShadowCasters';

const frustum = new Frustum();
const whole = new Matrix4();
const right = new Vector3();
const up = new Vector3();
const back = new Vector3();

/** A camera that draws one tile, and what it sees. */
export class ShadowFace {
  private readonly ownPlanes = new Float64Array(24);
  private readonly partPlanes = new Float64Array(24);
  /** The planes are those of its view; of what it draws. */
  private hasPlanes = false;
  private hasPartPlanes = false;
  /** What it draws in this frame by itself. */
  readonly casters: Caster[] = [];
  private readonly merged: (TriangleRuns | undefined)[] = [];
  /** From world to clip space, where that was asked for. */
  readonly matrix = new Matrix4();
  /** The part of what it draws to that can be seen, and the part that is drawn (texels). */
  readonly part = { left: 0, bottom: 0, right: 0, top: 0 };
  readonly drawn = { left: 0, bottom: 0, right: 0, top: 0 };
  /** Of a cube: near, far, widening and the kind of depth that its camera's projection was made with, see `aimCubeFace`. */
  readonly aim = new Float64Array(4);
  /** Part of the atlas that it draws to (texels). */
  x = 0;
  y = 0;
  width = 0;
  height = 0;

  constructor(readonly camera: Camera) {}

  /** The six planes of its view in world space, as `viewFrustumPlanes` has them. */
  get planes(): Float64Array {
    if (!this.hasPlanes) this.findPlanes();
    return this.ownPlanes;
  }

  /** The same of the part of it that is drawn. */
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

  /** What it draws of a page of the merged casters, of those of which one side is seen (three's `Side`). */
  runs(page: number, side: number): TriangleRuns {
    return (this.merged[page * 3 + side] ??= new TriangleRuns());
  }

  /** True when what can be seen is within what is drawn. */
  get isCovered(): boolean {
    const { part, drawn } = this;
    if (part.left >= part.right || part.bottom >= part.top) return true;
    const across = part.left >= drawn.left && part.right <= drawn.right;
    return across && part.bottom >= drawn.bottom && part.top <= drawn.top;
  }

  /** Texels that it draws to. */
  get texels(): number {
    const { left, bottom, right, top } = this.drawn;
    return Math.max(0, right - left) * Math.max(0, top - bottom);
  }

  /** Has it draw what can be seen alone, or all. */
  draws(all: boolean): void {
    const { drawn, part } = this;
    drawn.left = all ? 0 : part.left;
    drawn.bottom = all ? 0 : part.bottom;
    drawn.right = all ? this.width : part.right;
    drawn.top = all ? this.height : part.top;
    this.hasPartPlanes = false;
  }

  /** Puts those of what is drawn in the place of the sides' planes. */
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

  clear(): void {
    this.casters.length = 0;
    for (const runs of this.merged) runs?.clear();
  }

  /** The camera's matrices have changed. */
  update(): void {
    this.hasPlanes = this.hasPartPlanes = false;
  }

  private findPlanes(): void {
    const { camera, ownPlanes: planes } = this;
    this.hasPlanes = true;
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

/** Where the cameras of a point light look and what is up there, as farol_cubeFace has it: +x, -x, +y, -y, +z, -z. */
const AXES = [
  [1, 0, 0, 0, 1, 0],
  [-1, 0, 0, 0, 1, 0],
  [0, 1, 0, 0, 0, 1],
  [0, -1, 0, 0, 0, 1],
  [0, 0, 1, 0, 1, 0],
  [0, 0, -1, 0, 1, 0],
] as const;

/** The six faces of a cube map, to be placed by `aimCubeFace`. */
export function makeCubeFaces(): ShadowFace[] {
  return AXES.map(() => {
    const camera = new PerspectiveCamera(90, 1, 0.5, 500);
    camera.matrixAutoUpdate = camera.matrixWorldAutoUpdate = false;
    return new ShadowFace(camera);
  });
}

/**
 * Puts the camera of one face in its place.
 * @param index of the face, 0 to 5
 * @param widening tangent of half its angle: 1 sees the face alone, more also what lies beside it
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
