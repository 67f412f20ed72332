/** Mapping of slopes (view-space lateral distance / depth) to tiles of the screen: `tile = slope × scale + offset`. */
export class GridFrame {
  tilesX = 0;
  tilesY = 0;
  /** True where a slope is lateral / depth; false (orthographic) where it is the lateral distance itself. */
  perspective = true;
  /** Tiles for a unit of slope, above 0; if the projection mirrors, `signX` or `signY` is -1 and positions are mirrored. */
  scaleX = 1;
  scaleY = 1;
  offsetX = 0;
  offsetY = 0;
  signX = 1;
  signY = 1;
  /** Half the width, and half the height, of the picture (tiles). */
  halfX = 0;
  halfY = 0;
  near = 0;
  far = 0;

  /**
   * @param m - projection, 16 elements, column-major
   * @param near - depth of the near plane (m), above 0 for a perspective
   * @param far - depth of the far plane (m), or Infinity
   */
  set(m: ArrayLike<number>, near: number, far: number, width: number, height: number, tileSize: number): void {
    this.tilesX = Math.ceil(width / tileSize);
    this.tilesY = Math.ceil(height / tileSize);
    this.perspective = m[11] !== 0;
    this.halfX = width / (2 * tileSize);
    this.halfY = height / (2 * tileSize);
    this.signX = m[0] < 0 ? -1 : 1;
    this.signY = m[5] < 0 ? -1 : 1;
    this.scaleX = Math.abs(m[0]) * this.halfX;
    this.scaleY = Math.abs(m[5]) * this.halfY;
    this.offsetX = ((this.perspective ? -m[8] : m[12]) + 1) * this.halfX;
    this.offsetY = ((this.perspective ? -m[9] : m[13]) + 1) * this.halfY;
    this.near = near;
    this.far = far;
  }
}
