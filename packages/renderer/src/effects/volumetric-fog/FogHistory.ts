import { type Camera, Matrix4, Vector4 } from 'three';
import { LightWatch } from '../antialiasing/LightWatch';
import { FroxelTexture } from './FroxelTexture';

/** Maximum number of frames that are averaged while nothing changes. */
const MOST = 64;
/** Maximum number of frames averaged after lights have changed. */
const CHANGED = 3;

/** Froxels of earlier frames, for one camera. */
export class FogHistory {
  readonly lights = new LightWatch();
  /** View matrix of the last frame. */
  readonly view = new Matrix4();
  /** Last frame's projection: xy scale, zw shift. */
  readonly ray = new Vector4();
  /** Number of frames drawn; selects the sample position within froxels. */
  frame = 0;
  /** Number of frames in the mean that the froxels hold. */
  count = 0;
  /** Weight of this frame in the mean, in slices that it computes; `otherShare`: in the other slices. */
  share = 1;
  otherShare = 1;
  /** Number of frames since lights changed. */
  private sinceLit = Infinity;
  /** Number of lights in the last frame. */
  lightCount = 0;
  /** Checksum of the last frame's settings, to detect changes. */
  settingsHash = 0;
  private readonly textures = [new FroxelTexture(), new FroxelTexture()];

  get bytes(): number {
    return this.textures[0].bytes + this.textures[1].bytes;
  }

  /** Froxels of the last frame. */
  get previous(): FroxelTexture {
    return this.textures[1 - (this.frame & 1)];
  }

  /** Froxels of this frame. */
  get current(): FroxelTexture {
    return this.textures[this.frame & 1];
  }

  /**
   * Counts a frame, and sets the weights by its changes.
   * @param most - number of frames in the mean while something moves
   * @param changed - whether lights have changed
   * @param isStill - whether camera, shadows and noise have not changed
   * @param turns - number of frames in which each slice is computed once
   * @param forgets - number of frames after a change of lights in which the mean stays short
   */
  note(most: number, changed: boolean, isStill: boolean, turns = 1, forgets = 0): void {
    this.sinceLit = changed ? 0 : this.sinceLit + 1;
    const isLit = changed || this.sinceLit <= forgets;
    const isFirst = this.count === 0;
    const limit = isLit ? Math.min(CHANGED, most) : isStill ? MOST * turns : Math.max(most, turns > 1 ? 2 * turns : 1);
    this.count = Math.min(this.count + 1, limit);
    this.share = 1 / (isLit ? this.count : Math.ceil(this.count / turns));
    // when lights change, slices not computed yet copy a neighbouring slice instead of showing old light
    this.otherShare = isFirst ? 1 : isLit ? this.share : 0;
  }

  /** Ends a frame: its froxels become `previous`. */
  advance(camera: Camera): void {
    const { elements: e } = camera.projectionMatrix;
    this.view.copy(camera.matrixWorldInverse);
    this.ray.set(e[0], e[5], e[8], e[9]);
    this.frame++;
  }

  /** Forgets earlier frames, and restarts the sample positions. */
  restart(): void {
    this.count = this.frame = 0;
  }

  dispose(): void {
    for (const texture of this.textures) texture.dispose();
    this.restart();
  }
}
