/** A rectangle of an atlas (texels). */
export interface Region {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** Rectangle of one shadow map in its atlas; written by the atlas alone. */
export class AtlasPlacement {
  private rectangle: Region | null = null;
  private width = 0;
  private height = 0;
  private edge = 0;
  private halved = 0;

  /** Rectangle of all faces together; null while the map has no region. */
  get region(): Region | null {
    return this.rectangle;
  }

  /** Width of a face in the last region, without borders (texels). */
  get faceWidth(): number {
    return this.width;
  }

  /** Height of a face in the last region, without borders (texels). */
  get faceHeight(): number {
    return this.height;
  }

  /** Width of the border round each face of a cube (texels); 0 for other maps. */
  get border(): number {
    return this.edge;
  }

  /** Number of times that the full atlas has halved the map's sides. */
  get halvings(): number {
    return this.halved;
  }

  /** Gives the map its rectangle. @throws Error when there is a region already */
  place(region: Region, faceWidth: number, faceHeight: number, border: number): void {
    if (this.rectangle !== null) throw new Error('A shadow map has a region already: release it before you place it.');
    this.rectangle = region;
    this.width = faceWidth;
    this.height = faceHeight;
    this.edge = border;
  }

  drop(): void {
    this.rectangle = null;
  }

  halve(): void {
    this.halved++;
  }

  /** Resets `halvings`, so that the map gets its full size again. */
  restore(): void {
    this.halved = 0;
  }
}
