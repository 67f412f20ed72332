import type { FileObject } from './FarolFile';
import type { Prefab } from '../core/Prefab';

/** Counts the prefab instances among objects, by prefab id. */
function innerOf(objects: readonly FileObject[]): Map<string, number> {
  const inner = new Map<string, number>();
  for (const { prefab: link } of objects) {
    if (link) inner.set(link.prefab, (inner.get(link.prefab) ?? 0) + (link.source === link.prefab ? 1 : 0));
  }
  return inner;
}

interface Step {
  readonly prefab: Prefab;
  readonly inner: [id: string, times: number][];
  next: number;
  depth: number;
  size: number;
}

/**
 * Nesting depth of prefabs, and number of objects in an instance of each, nested instances included. Each prefab is
 * visited once, without recursion; no objects are made.
 */
export class PrefabSizes {
  /** Cycles of prefabs that contain themselves, each as a list of ids whose first and last are equal. */
  readonly rings: string[][] = [];

  private readonly found = new Map<string, { readonly depth: number; readonly size: number }>();

  constructor(private readonly prefabs: ReadonlyMap<string, Prefab>) {
    for (const prefab of prefabs.values()) this.visit(prefab);
  }

  /** Nesting depth of a prefab: 1 without nested prefabs. 0 for an unknown prefab. */
  depthOf(id: string): number {
    return this.found.get(id)?.depth ?? 0;
  }

  /** Number of objects in an instance of a prefab, nested instances included. 0 for an unknown prefab. */
  sizeOf(id: string): number {
    return this.found.get(id)?.size ?? 0;
  }

  /** Number of objects in a list, with all objects of their prefab instances. */
  sizeOfObjects(objects: readonly FileObject[]): number {
    let size = objects.reduce((sum, { prefab }) => sum + (prefab ? 0 : 1), 0);
    for (const [id, times] of innerOf(objects)) size += times * this.sizeOf(id);
    return Math.max(size, objects.length);
  }

  private visit(first: Prefab): void {
    const stack: Step[] = [];
    const open = new Set<string>();
    const enter = (prefab: Prefab): void => {
      open.add(prefab.id);
      stack.push({ prefab, inner: [...innerOf(prefab.objects)], next: 0, depth: 0, size: 0 });
    };
    if (!this.found.has(first.id)) enter(first);
    while (stack.length > 0) {
      const step = stack.at(-1)!;
      if (step.next < step.inner.length) {
        const [id] = step.inner[step.next++];
        const prefab = this.prefabs.get(id);
        if (!prefab || this.found.has(id)) continue;
        if (!open.has(id)) {
          enter(prefab);
          continue;
        }
        const ids = stack.map((each) => each.prefab.id);
        this.rings.push([...ids.slice(ids.indexOf(id)), id]);
        continue;
      }
      const depth = step.inner.reduce((deepest, [id]) => Math.max(deepest, this.depthOf(id)), 0) + 1;
      this.found.set(step.prefab.id, { depth, size: this.sizeOfObjects(step.prefab.objects) });
      open.delete(step.prefab.id);
      stack.pop();
    }
  }
}
