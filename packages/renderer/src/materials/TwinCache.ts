import type { Material } from 'three';
import { createTwin, type TwinContext } from './createTwin';
import { threeChunks } from '../three/ThreeChunks';
import type { TwinKind } from './TwinKind';

/** Twins by source and kind. A twin is disposed with its source, and all of them with the cache. */
export class TwinCache {
  private readonly twins = new WeakMap<Material, Map<TwinKind, Material>>();
  private readonly sources = new Map<number, WeakRef<Material>>();

  /** Twin that was asked for last, with its source and kind: draws come by material. */
  private last: Material | null = null;
  private lastSource: Material | null = null;
  private lastKind: TwinKind | null = null;
  private revision = 0;

  constructor(private readonly context: TwinContext) {}

  get(source: Material, kind: TwinKind): Material {
    if (source === this.lastSource && kind === this.lastKind) return this.last!;
    this.lastKind = kind;
    this.lastSource = source;
    return (this.last = this.find(source, kind));
  }

  private find(source: Material, kind: TwinKind): Material {
    let kinds = this.twins.get(source);
    if (kinds === undefined) {
      this.twins.set(source, (kinds = new Map()));
      this.sources.set(source.id, new WeakRef(source));
      source.addEventListener('dispose', this.forget);
    }
    let twin = kinds.get(kind);
    if (twin === undefined) kinds.set(kind, (twin = createTwin(source, kind, this.context)));
    return twin;
  }

  /** Begins a frame, without a hold on a material of the last one: twins of shaders that the page has changed since are made anew. */
  begin(): void {
    this.last = this.lastSource = this.lastKind = null;
    threeChunks.follow();
    if (this.revision !== threeChunks.revision) this.dispose();
    this.revision = threeChunks.revision;
  }

  dispose(): void {
    for (const reference of this.sources.values()) {
      const target = reference.deref();
      if (target) this.forget({ target });
    }
  }

  private readonly forget = ({ target }: { target: Material }) => {
    target.removeEventListener('dispose', this.forget);
    this.last = this.lastSource = this.lastKind = null;
    this.sources.delete(target.id);
    for (const twin of this.twins.get(target)!.values()) twin.dispose();
    this.twins.delete(target);
  };
}
