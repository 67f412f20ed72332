import { type Camera, Matrix4, Vector4 } from 'three';
import { LightWatch } from '../antialiasing/LightWatch';
import { FroxelTexture } from './FroxelTexture';

/** Maximum number of frames that are averaged while nothing changes. */
const MOST = 64;
/** Maximum number of frames averaged after lights have changed. */
const CHANGED = 3;

/** Froxels of the frames before, for one camera. */
export class FogHistory {
  readonly lights = new LightWatch();
  /** From world space to view space, in the last frame. */
  readonly view = new Matrix4();
  /** x and y scale of the last frame's projection, and its x and y shift. */
  readonly ray = new Vector4();
  /** Frames drawn; chooses the place in the froxels. */
  frame = 0;
  /** Frames in the mean; 0 for none. */
  count = 0;
  /** Weight of this frame in slices that it lights; `otherShare`: in slices that it does not light. */
  share = 1;
  otherShare = 1;
  /** Frames since lights changed. */
  private sinceLit = Infinity;
  /** Lights of the last frame. */
  lightCount = 0;
  /** Sum over the settings of the last frame, by which changes are found. */
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
   * Counts a frame, by what has changed since the last.
   * @param most - frames in the mean while things move
   * @param changed - whether lights have changed
   * @param isStill - whether neither the camera nor shadows nor the noise have
   * @param turns - frames in which each slice is lit once
   * @param forgets - frames in which the mean stays short after lights have changed
   */
  note(most: number, changed: boolean, isStill: boolean, turns = 1, forgets = 0): void {
    this.sinceLit = changed ? 0 : this.sinceLit + 1;
    const isLit = changed || this.sinceLit <= forgets;
    const isFirst = this.count === 0;
    const limit = isLit ? Math.min(CHANGED, most) : isStill ? MOST * turns : Math.max(most, turns > 1 ? 2 * turns : 1);
    this.count = Math.min(this.count + 1, limit);
    this.share = 1 / (isLit ? this.count : Math.ceil(this.count / turns));
    // a slice that waits for its turn shows what is lit beside it, rather than light that is gone
    this.otherShare = isFirst ? 1 : isLit ? this.share : 0;
  }

  /** Ends a frame: it is the last one from now on. */
  advance(camera: Camera): void {
    const { elements: e } = camera.projectionMatrix;
    this.view.copy(camera.matrixWorldInverse);
    this.ray.set(e[0], e[5], e[8], e[9]);
    this.frame++;
  }

  /** Forgets the frames before, and begins with the first place in the froxels. */
  restart(): void {
    this.count = this.frame = 0;
  }

  dispose(): void {
    for (const texture of this.textures) texture.dispose();
    this.restart();
  }
}
