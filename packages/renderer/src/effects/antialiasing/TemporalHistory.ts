import {
  type Camera,
  HalfFloatType,
  Matrix4,
  type Object3D,
  type Texture,
  Vector3,
  type WebGLRenderTarget,
} from 'three';
import { EffectTarget } from '../EffectTarget';
import type { ObjectMotion } from './ObjectMotion';

/** What temporal anti-aliasing keeps of the frames of one camera and scene. */
export class TemporalHistory {
  /** How objects stood in the last frame. */
  motions = new WeakMap<Object3D, ObjectMotion>();
  /** Projection × view of the last frame, without jitter. */
  readonly viewProjection = new Matrix4();
  /** The camera's backward axis (world space) in the last frame. */
  readonly forward = new Vector3();
  /** Frames since the last reset, and since anything changed. */
  count = 0;
  still = 0;
  /** Number of the last frame, never put back. */
  frame = 0;
  /** Of the last frame, by `looksOf`. */
  looks = 0;
  /** When it was last drawn; the caller's count. */
  usedAt = 0;
  private readonly targets = [
    new EffectTarget({ type: HalfFloatType }, 8),
    new EffectTarget({ type: HalfFloatType }, 8),
  ];
  private width = 0;
  private height = 0;
  private last: Texture | null = null;

  constructor(
    readonly camera: Camera,
    readonly scene: Object3D,
  ) {}

  get bytes(): number {
    return this.targets[0].bytes + this.targets[1].bytes;
  }

  /** True when there is no past to look at. */
  get isEmpty(): boolean {
    return this.count === 0;
  }

  /** The last frame's picture, linear. */
  get texture(): Texture | null {
    return this.last;
  }

  hasSize(width: number, height: number): boolean {
    return this.width === width && this.height === height;
  }

  /** What this frame is to be drawn to. */
  next(width: number, height: number): WebGLRenderTarget {
    this.width = width;
    this.height = height;
    return this.targets[this.frame & 1].of(width, height);
  }

  /** Ends a frame: what was drawn is the past now. */
  advance(viewProjection: Matrix4, camera: Camera): void {
    this.last = this.targets[this.frame & 1].of(this.width, this.height).texture;
    this.viewProjection.copy(viewProjection);
    this.forward.setFromMatrixColumn(camera.matrixWorld, 2).normalize();
    this.count++;
    this.frame++;
  }

  reset(): void {
    this.count = this.still = 0;
  }

  dispose(): void {
    for (const target of this.targets) target.dispose();
    this.motions = new WeakMap();
    this.reset();
  }
}
