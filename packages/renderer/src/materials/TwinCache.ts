import type { Material } from 'three';
import { createTwin, type TwinContext } from './createTwin';
import { threeChunks } from '../three/ThreeChunks';
import type { TwinKind } from './TwinKind';

/** Twins by source material and kind. A twin is disposed with its source, and all with the cache. */
export class TwinCache {
  private readonly twins = new WeakMap<Material, Map<TwinKind, Material>>();
  private readonly sources = new Map<number, WeakRef<Material>>();

  private revision = 0;
  /** Number of frames in a row that began after the page had changed three's shaders. */
  private changes = 0;
  /** Source, kind and twin of the last `get`: most draws have the same material as the draw before. */
  private lastSource: Material | null = null;
  private lastKind!: TwinKind;
  private lastTwin!: Material;

  constructor(private readonly context: TwinContext) {}

  get(source: Material, kind: TwinKind): Material {
    if (source === this.lastSource && kind === this.lastKind) return this.lastTwin;
    let kinds = this.twins.get(source);
    if (kinds === undefined) {
      this.twins.set(source, (kinds = new Map()));
      this.sources.set(source.id, new WeakRef(source));
      source.addEventListener('dispose', this.forget);
    }
    let twin = kinds.get(kind);
    if (twin === undefined) kinds.set(kind, (twin = createTwin(source, kind, this.context)));
    this.lastSource = source;
    this.lastKind = kind;
    return (this.lastTwin = twin);
  }

  /** Begins a frame. Drops all twins if the page has changed three's shader chunks. */
  begin(): void {
    threeChunks.follow(this.revision > 0);
    const isChanged = this.revision !== threeChunks.revision;
    this.changes = isChanged ? this.changes + 1 : 0;
    if (isChanged) this.dispose();
    this.revision = threeChunks.revision;
  }

  /** Whether the page changed shaders during this frame, so that it must be drawn again. */
  get isOutdated(): boolean {
    return this.revision !== threeChunks.revision && this.changes < 2;
  }

  dispose(): void {
    for (const reference of this.sources.values()) {
      const target = reference.deref();
      if (target) this.forget({ target });
    }
  }

  private readonly forget = ({ target }: { target: Material }) => {
    this.lastSource = null;
    target.removeEventListener('dispose', this.forget);
    this.sources.delete(target.id);
    for (const twin of this.twins.get(target)!.values()) twin.dispose();
    this.twins.delete(target);
  };
}
