import { formatCount, t } from '@farol/editing';

/** Maximum number of object names that are listed for each kind of loss. */
const MOST_NAMES = 3;

/** Counts by kind what a glTF file lacks. */
export class LeftOut {
  private readonly kinds = new Map<string, Set<unknown>>();
  private readonly names = new Map<string, Set<string>>();

  /**
   * @param kind - a sentence without full stop @param thing - counted once; absent when there is nothing to count
   *   @param name - name of an object; the first three are listed
   */
  add(kind: string, thing?: unknown, name?: string): void {
    let things = this.kinds.get(kind);
    if (!things) this.kinds.set(kind, (things = new Set()));
    if (thing !== undefined) things.add(thing);
    if (name === undefined) return;
    const names = this.names.get(kind);
    if (names) names.add(name);
    else this.names.set(kind, new Set([name]));
  }

  /** Counts a surface (GLSL on a material) that is left out. @param object - name of the object */
  addSurface(surface: string, object: string): void {
    this.add(t('The surface {surface} is left out', { surface }), object, object);
  }

  /** One line for each kind, with the count. */
  get lines(): string[] {
    return [...this.kinds].map(([kind, { size }]) => {
      const names = [...(this.names.get(kind) ?? [])];
      const listedNames = names.slice(0, MOST_NAMES).join(', ') + (names.length > MOST_NAMES ? ', …' : '');
      return `${kind}${listedNames && `: ${listedNames}`}${size > 0 ? ` (${formatCount(size)})` : ''}`;
    });
  }
}
