/** Number of frames (of any camera) in a row in which a shadow map is finer than pictures show, before its side is halved. */
const PATIENCE = 30;
/** Number of eighths of a halving by which a shadow map must be too fine before its side is halved. */
const MARGIN = 2;

/**
 * Level of detail of a map: number of times that the size set by its light is halved, because pictures would not show more
 * texels. It rises (fewer texels) only after a while, and falls at once.
 */
export class MapDetail {
  private applied = 0;
  private sufficient = 0;
  /** Number of frames in a row in which a higher level would have sufficed, and the least of those levels. */
  private patience = 0;
  private leastSufficient = 0;

  /** Number of halvings that the map has, or will have once it is placed. */
  get level(): number {
    return this.applied;
  }

  /** Number of times that the side of the map is to be halved. */
  get target(): number {
    return this.sufficient;
  }

  /** Sets the number of halvings of a map without a region, at once. */
  start(level: number): void {
    this.patience = 0;
    this.applied = this.sufficient = level;
  }

  /**
   * Sets `target` for a map that has a region.
   * @param eighths - number of halvings that this camera's picture allows, in eighths
   * @param updates - whether the map is redrawn on changes; a map that is not redrawn must suffice for all cameras
   */
  aim(eighths: number, updates: boolean): void {
    const { applied } = this;
    const less = updates ? (eighths - MARGIN) >> 3 : 0;
    if (less <= applied) {
      this.patience = 0;
      this.sufficient = Math.min(eighths >> 3, applied);
      return;
    }
    this.leastSufficient = this.patience === 0 ? less : Math.min(this.leastSufficient, less);
    this.patience++;
    this.sufficient = this.patience > PATIENCE ? this.leastSufficient : applied;
  }

  /** Sets the map's present number of halvings to the target. */
  reach(): void {
    this.applied = this.sufficient;
    this.patience = 0;
  }

  /**
   * Makes the target the map's number of halvings, while all maps of a full atlas are resized; unlike `reach`, does not
   * restart the wait for a smaller map.
   */
  settle(): void {
    this.applied = this.sufficient;
  }
}
