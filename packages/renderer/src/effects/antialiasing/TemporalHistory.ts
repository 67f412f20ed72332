import {
  type Camera,
  HalfFloatType,
  Matrix4,
  LinearFilter,
  type Object3D,
  RGFormat,
  type Texture,
  Vector2,
  Vector3,
  Vector4,
  type WebGLRenderTarget,
} from 'three';
import { PassTarget } from '../../gpu/PassTarget';
import { LightWatch } from './LightWatch';
import { ObjectMotions } from './ObjectMotions';
import { ReactiveMasks } from './ReactiveMasks';

const CELLS = { type: HalfFloatType, minFilter: LinearFilter, magFilter: LinearFilter } as const;
const REACH = { type: HalfFloatType, format: RGFormat } as const;

/** State that temporal anti-aliasing keeps from frame to frame, for one camera and scene. */
export class TemporalHistory {
  /** States of objects in the last frame. */
  readonly motions = new ObjectMotions();
  /** Pixels whose history is ignored: those of particles and other surfaces that change without motion. */
  readonly reactive = new ReactiveMasks();
  readonly lights = new LightWatch();
  /** Projection × view of the last frame, without jitter. */
  readonly viewProjection = new Matrix4();
  /** The camera's backward axis (world space) in the last frame. */
  readonly forward = new Vector3();
  /** Size of the picture in the last frame (pixels). */
  readonly sizeBefore = new Vector2();
  /** Number of frames accumulated since the last reset. */
  count = 0;
  /** Number of frames since any change of the picture; Infinity after a reset. */
  quiet = Infinity;
  sure = Infinity;
  known = Infinity;
  /** Number of the last frame; `reset` does not change it. */
  frame = 0;
  /** Hash of the last frame's materials and surroundings, from `looksOf` and `surroundingsOf`. */
  materialHash = 0;
  /** Sum of the weights of the samples in each cell of a pixel, since the picture last changed. */
  readonly gathered = new Vector4();
  private readonly targets = [new PassTarget(CELLS), new PassTarget(CELLS)];
  private readonly reaches = [new PassTarget(REACH), new PassTarget(REACH)];
  private width = 0;
  private height = 0;
  private cells = 1;
  private last: Texture | null = null;
  private lastReach: Texture | null = null;

  constructor(
    readonly camera: Camera,
    readonly scene: Object3D,
  ) {}

  get bytes(): number {
    const { targets, reaches, reactive } = this;
    return targets[0].bytes + targets[1].bytes + reaches[0].bytes + reaches[1].bytes + reactive.bytes;
  }

  /** Whether there is no earlier frame to use. */
  get isEmpty(): boolean {
    return this.count === 0;
  }

  /** History colours: linear, one texel a cell. */
  get texture(): Texture | null {
    return this.last;
  }

  /** Distances of the last frame's surfaces, written by taaNear.glsl. */
  get reach(): Texture | null {
    return this.lastReach;
  }

  hasSize(width: number, height: number, cells: number): boolean {
    return this.width === width && this.height === height && this.cells === cells;
  }

  /** Cells along a pixel's side in this history if their number must stay (`keeps`); 0 if it may change or is unset. */
  cellsOf(keeps: boolean): number {
    return keeps && !this.isEmpty ? this.cells : 0;
  }

  /** Sets size (pixels) and cells along a pixel's side of the targets `next` and `nextReach`. */
  setSize(width: number, height: number, cells: number): void {
    this.width = width;
    this.height = height;
    this.cells = cells;
  }

  get next(): WebGLRenderTarget {
    return this.targets[this.frame & 1].of(this.width * this.cells, this.height * this.cells);
  }

  get nextReach(): WebGLRenderTarget {
    return this.reaches[this.frame & 1].of(this.width, this.height);
  }

  /** Ends a frame: its targets become the next frame's history. */
  advance(viewProjection: Matrix4, camera: Camera): void {
    this.sizeBefore.set(this.width, this.height);
    this.last = this.next.texture;
    this.lastReach = this.nextReach.texture;
    this.viewProjection.copy(viewProjection);
    this.forward.setFromMatrixColumn(camera.matrixWorld, 2).normalize();
    this.reactive.advance();
    this.count++;
    this.frame++;
  }

  reset(): void {
    this.reactive.reset();
    this.count = 0;
    this.quiet = this.sure = this.known = Infinity;
  }

  dispose(): void {
    for (const target of [...this.targets, ...this.reaches]) target.dispose();
    this.motions.dispose();
    this.reactive.dispose();
    this.reset();
  }
}
