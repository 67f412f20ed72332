import { formatCount, t } from '@farol/editing';

/** How many names of objects a line has. */
const MOST_NAMES = 3;

/** What a glTF could not take along, counted by kind. */
export class LeftOut {
  private readonly kinds = new Map<string, Set<unknown>>();
  private readonly names = new Map<string, Set<string>>();

  /** @param kind - a sentence without its dot @param thing - counted once; none where there is nothing to count @param name - of an object, to be told; the first three are */
  add(kind: string, thing?: unknown, name?: string): void {
    let things = this.kinds.get(kind);
    if (!things) this.kinds.set(kind, (things = new Set()));
    if (thing !== undefined) things.add(thing);
    if (name === undefined) return;
    const names = this.names.get(kind);
    if (names) names.add(name);
    else this.names.set(kind, new Set([name]));
  }

  /** A surface made of microshaders, of an object by its name. */
  addSurface(surface: string, object: string): void {
    this.add(t('The surface {surface} is left out', { surface }), object, object);
  }

  /** A line for each kind, with how many there are. */
  get lines(): string[] {
    return [...this.kinds].map(([kind, { size }]) => {
      const names = [...(this.names.get(kind) ?? [])];
      const told = names.slice(0, MOST_NAMES).join(', ') + (names.length > MOST_NAMES ? ', …' : '');
      return `${kind}${told && `: ${told}`}${size > 0 ? ` (${formatCount(size)})` : ''}`;
    });
  }
}
