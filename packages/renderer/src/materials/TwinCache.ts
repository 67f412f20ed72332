import type { Material } from 'three';
import { createTwin, type TwinContext } from './createTwin';
import type { TwinKind } from './TwinKind';

/** Twins by source and kind. A twin is disposed with its source, and all of them with the cache. */
export class TwinCache {
  private readonly kinds = new Map<TwinKind, WeakMap<Material, Material>>();
  private readonly all = new Map<number, WeakRef<Material>>();

  constructor(private readonly context: TwinContext) {}

  get(source: Material, kind: TwinKind): Material {
    let twins = this.kinds.get(kind);
    if (twins === undefined) this.kinds.set(kind, (twins = new WeakMap()));
    let twin = twins.get(source);
    if (twin === undefined) {
      twin = createTwin(source, kind, this.context);
      twins.set(source, twin);
      this.watch(source, twin, twins);
    }
    return twin;
  }

  dispose(): void {
    for (const reference of this.all.values()) reference.deref()?.dispose();
    this.all.clear();
    this.kinds.clear();
  }

  private watch(source: Material, twin: Material, twins: WeakMap<Material, Material>): void {
    const { all } = this;
    all.set(twin.id, new WeakRef(twin));
    const onDispose = () => {
      source.removeEventListener('dispose', onDispose);
      twins.delete(source);
      all.delete(twin.id);
      twin.dispose();
    };
    source.addEventListener('dispose', onDispose);
  }
}
