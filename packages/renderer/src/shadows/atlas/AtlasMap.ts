/**
 * State of an atlas region that holds one shadow map (or image).
 *
 * | state | the region |
 * |---|---|
 * | none | does not exist |
 * | empty | is new: holds nothing |
 * | lost | has lost its content, with the context or the atlas' texture; casters have not changed since |
 * | partial | holds the map where receivers can be seen |
 * | whole | holds all of the map |
 * | stale-partial, stale-whole | holds a map, but casters have changed since |
 */
export type MapState = 'none' | 'empty' | 'lost' | 'partial' | 'whole' | 'stale-partial' | 'stale-whole';

const AFTER_CHANGE: Record<MapState, MapState> = {
  none: 'none',
  empty: 'empty',
  lost: 'empty',
  partial: 'stale-partial',
  whole: 'stale-whole',
  'stale-partial': 'stale-partial',
  'stale-whole': 'stale-whole',
};

const AFTER_LOSS: Record<MapState, MapState> = {
  none: 'none',
  empty: 'empty',
  lost: 'lost',
  partial: 'lost',
  whole: 'lost',
  'stale-partial': 'empty',
  'stale-whole': 'empty',
};

/** State of one shadow map or cookie in its atlas; only methods of this class change it. README.md lists their callers. */
export class AtlasMap {
  /** Number of the last frame in which the map was out of date; written by `noteAge`. */
  since = 0;
  private current: MapState = 'none';
  private planned: 'partial' | 'whole' | null = null;
  private bounds = false;
  private drawn = false;

  get state(): MapState {
    return this.current;
  }

  /** Whether the atlas region holds a map, up to date or not. */
  get isThere(): boolean {
    const { current } = this;
    return current !== 'none' && current !== 'empty' && current !== 'lost';
  }

  /** Whether the region holds all of the map that was planned, up to date. */
  get isCurrent(): boolean {
    return this.current === 'partial' || this.current === 'whole';
  }

  /** Whether the map was not drawn yet, or a caster has changed since. */
  get isStale(): boolean {
    const { current } = this;
    return current !== 'partial' && current !== 'whole' && current !== 'lost';
  }

  /** Whether the region holds only those parts of the map where receivers could be seen. */
  get isPartial(): boolean {
    return this.current === 'partial' || this.current === 'stale-partial';
  }

  /** Whether `ShadowBounds` has found the least and greatest depths in the map as drawn. */
  get hasBounds(): boolean {
    return this.bounds;
  }

  /** Whether the map was drawn at least once: a lost map is drawn anew even when the host has turned updates off. */
  get wasDrawn(): boolean {
    return this.drawn;
  }

  /** Notes that the map has got a region of the atlas. */
  place(): void {
    this.current = 'empty';
    this.planned = null;
    this.bounds = false;
  }

  /** Notes that the map has no region of the atlas any more. */
  release(): void {
    this.current = 'none';
    this.planned = null;
    this.bounds = false;
  }

  /** Marks the drawn content as lost, with the GL context or the atlas texture. */
  lose(): void {
    this.current = AFTER_LOSS[this.current];
    if (!this.isThere) this.bounds = false;
  }

  /** Marks the map as stale: a caster in it has changed. */
  change(): void {
    this.current = AFTER_CHANGE[this.current];
  }

  /** Stores the number of the frame in `since` while the map is out of date. */
  noteAge(frame: number): void {
    if (this.isStale) this.since = frame;
  }

  /** Marks the map as one to be drawn in this frame. @throws Error when there is no region to draw to */
  plan(isPartial: boolean): void {
    if (this.current === 'none') throw new Error('A map without a region cannot be drawn: place it in an atlas first.');
    this.planned = isPartial ? 'partial' : 'whole';
    this.bounds = false;
  }

  /** Notes that the map is drawn as planned. @throws Error when no draw was planned */
  draw(): void {
    if (this.planned === null) throw new Error('A shadow map was drawn before it was planned: call plan() first.');
    this.current = this.planned;
    this.planned = null;
    this.drawn = true;
  }

  /**
   * Notes that `ShadowBounds` has found the map's least and greatest depths.
   * @throws Error when there are no depths
   */
  bound(): void {
    if (!this.isThere) throw new Error('A shadow map has no bounds before it is drawn: draw it first.');
    this.bounds = true;
  }
}
