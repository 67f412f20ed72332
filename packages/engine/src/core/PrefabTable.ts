import { type Prefab, PrefabError } from './Prefab';

/** The prefabs of a scene, by id. */
export class PrefabTable {
  private readonly byId = new Map<string, Prefab>();

  /** @param changed - called with the id of a prefab that was set or deleted */
  constructor(private readonly changed: (id: string) => void) {}

  get list(): readonly Prefab[] {
    return [...this.byId.values()];
  }

  get(id: string): Prefab | null {
    return this.byId.get(id) ?? null;
  }

  /** Adds a prefab, or replaces the one of the same id. Existing instances are not updated: see `planPrefabChange`. */
  set(prefab: Prefab): void {
    if (this.byId.get(prefab.id) === prefab) return;
    if (prefab.objects[0]?.id !== prefab.id) throw new PrefabError(prefab.name, 'must begin with its root object.');
    this.byId.set(prefab.id, prefab);
    this.changed(prefab.id);
  }

  /** Removes a prefab. Its instances keep their values and are no longer updated. */
  delete(id: string): void {
    if (this.byId.delete(id)) this.changed(id);
  }

  /** Whether the prefab `id` is `inner`, or contains an instance of `inner` at any depth. */
  contains(id: string, inner: string): boolean {
    return this.anyContains([id], inner);
  }

  /**
   * Whether any of the prefabs `ids` is `inner`, or holds an instance of `inner` at any depth. Visits each prefab once.
   */
  anyContains(ids: Iterable<string>, inner: string): boolean {
    const seen = new Set(ids);
    for (const id of seen) {
      if (id === inner) return true;
      // iterating over a Set includes entries that are added meanwhile
      for (const { prefab } of this.get(id)?.objects ?? []) if (prefab) seen.add(prefab.prefab);
    }
    return false;
  }
}
