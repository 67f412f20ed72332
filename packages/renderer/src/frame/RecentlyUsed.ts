/** Time for which an unused object is kept while others are used (ms). */
const KEPT = 2000;
/** Maximum number of objects kept besides the one in use. */
const MOST = 3;

/**
 * Releases objects held for alternating scenes or cameras: those not used for a while, sooner the more there are. Counts time,
 * not frames, since a host may draw none. The one used last is never released.
 */
export class RecentlyUsed<Key> {
  private current: Key | null = null;
  /** Time of last use (ms) of each object except the one in use, in the order of these times. */
  private readonly lastUses = new Map<Key, number>();
  private timer: ReturnType<typeof setTimeout> | null = null;

  constructor(private readonly release: (key: Key) => void) {}

  /** Records a use; call it at each use. */
  use(key: Key): void {
    const { current, lastUses } = this;
    if (key === current) return;
    if (current !== null) lastUses.set(current, performance.now());
    this.current = key;
    lastUses.delete(key);
    for (const oldest of lastUses.keys()) if (lastUses.size > MOST) this.drop(oldest);
    if (lastUses.size > 0) this.timer ??= setTimeout(this.sweep, KEPT);
  }

  /** Forgets all keys without releasing them. */
  clear(): void {
    if (this.timer !== null) clearTimeout(this.timer);
    this.timer = this.current = null;
    this.lastUses.clear();
  }

  private drop(key: Key): void {
    this.lastUses.delete(key);
    this.release(key);
  }

  private readonly sweep = (): void => {
    this.timer = null;
    const now = performance.now();
    for (const [key, since] of this.lastUses) if (now - since >= KEPT) this.drop(key);
    if (this.lastUses.size > 0) this.timer = setTimeout(this.sweep, KEPT);
  };
}
