import type { FieldTable, FieldValue } from '@farol/editing/fields';
import type { FieldOwner, FieldViews } from './FieldOwner';
import { entryOf, readStored, type StoredValues, withEntry, storedValue } from './storedValues';

/** Returns the views that an owner has at present, as the same table while they do not change; null for none. */
export type ViewSource = () => FieldTable | null;

interface Held {
  readonly text: string;
  readonly values: StoredValues;
}

/** Fields of an owner whose values are stored in declared fields, such as a surface's uniforms: see `storedValues`. */
export class StoredViews implements FieldViews {
  private table: FieldTable;
  private readonly found: (FieldTable | null)[];
  /** Last parsed values, by the name of the field that stores them. */
  private readonly held = new Map<string, Held>();

  /** @param declared - the owner's declared fields */
  constructor(
    private readonly owner: FieldOwner,
    private readonly declared: FieldTable,
    private readonly sources: readonly ViewSource[],
  ) {
    this.table = declared;
    this.found = sources.map(() => null);
  }

  get fields(): FieldTable {
    const { sources, found } = this;
    let isSame = true;
    for (let i = 0; i < sources.length; i++) {
      const views = sources[i]();
      if (views === found[i]) continue;
      found[i] = views;
      isSame = false;
    }
    if (!isSame) this.table = found.some(Boolean) ? Object.assign({ ...this.declared }, ...found) : this.declared;
    return this.table;
  }

  has(name: string): boolean {
    const { fields } = this;
    return Object.hasOwn(fields, name) && fields[name].viewOf !== undefined;
  }

  get(name: string): FieldValue {
    const field = this.fields[name];
    const place = field.viewOf!;
    return field.kind === 'asset'
      ? this.owner.getAuthored(place)
      : storedValue(field, this.values(place)[entryOf(name)]);
  }

  set(name: string, value: FieldValue): void {
    const field = this.fields[name];
    const place = field.viewOf!;
    this.owner.set(place, field.kind === 'asset' ? value : withEntry(this.values(place), name, field, value));
  }

  private values(place: string): StoredValues {
    const text = this.owner.getAuthored(place) as string;
    const known = this.held.get(place);
    if (known?.text === text) return known.values;
    const values = readStored(text);
    this.held.set(place, { text, values });
    return values;
  }
}
