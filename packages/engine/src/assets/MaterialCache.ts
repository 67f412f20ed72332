import type { Material, Texture } from 'three';
import { makeMaterial, materialSettings, writeMaterial } from './makeMaterial';
import type { MaterialValues } from './materialFields';
import type { UseCounter } from './UseCounter';

/** Source of a cache's textures: an AssetLibrary. */
export interface TextureSource {
  readonly uses: UseCounter;
  isReady(type: 'texture', name: string): boolean;
  /** Calls back once the texture is available. */
  whenReady(type: 'texture', name: string, callback: () => void): void;
  texture(name: string, repeat: number, isData: boolean): Texture;
}

interface Entry {
  key: string;
  readonly kind: string;
  readonly material: Material;
  readonly textures: Set<Texture>;
  users: number;
}

/**
 * Materials made from field values. Users with equal values share one material; when a value of one user changes, that
 * user alone gets another material, or its own is changed in place when nobody shares it.
 */
export class MaterialCache {
  private readonly entries = new Map<string, Entry>();
  private readonly byMaterial = new Map<Material, Entry>();

  constructor(private readonly assets: TextureSource) {}

  get size(): number {
    return this.entries.size;
  }

  /** A material with these values; give it back with `release`. */
  acquire(values: MaterialValues): Material {
    const key = JSON.stringify(materialSettings(values));
    let entry = this.entries.get(key);
    if (!entry) {
      entry = { key, kind: values.kind, material: makeMaterial(values.kind), textures: new Set(), users: 0 };
      this.write(entry, values);
      this.entries.set(key, entry);
      this.byMaterial.set(entry.material, entry);
    }
    entry.users++;
    return entry.material;
  }

  /** Material for changed values of a user: the same material, changed in place, when nobody else uses it. */
  change(material: Material, values: MaterialValues): Material {
    const entry = this.byMaterial.get(material);
    const key = JSON.stringify(materialSettings(values));
    if (entry?.key === key) return material;
    if (!entry || entry.users > 1 || entry.kind !== values.kind || this.entries.has(key)) {
      const other = this.acquire(values);
      if (entry) this.release(material);
      return other;
    }
    this.entries.delete(entry.key);
    entry.key = key;
    this.entries.set(key, entry);
    this.write(entry, values);
    return material;
  }

  /** Releases one use of a material, which is disposed of after the last. */
  release(material: Material): void {
    const entry = this.byMaterial.get(material);
    if (!entry || --entry.users > 0) return;
    this.entries.delete(entry.key);
    this.byMaterial.delete(material);
    for (const texture of entry.textures) this.assets.uses.release(texture);
    material.dispose();
  }

  /** Disposes of every cached material, used or not. */
  dispose(): void {
    for (const { material } of this.entries.values()) material.dispose();
    this.entries.clear();
    this.byMaterial.clear();
  }

  /** Writes values and textures to a material; textures are set once loaded. */
  private write(entry: Entry, values: MaterialValues): void {
    const before = [...entry.textures];
    entry.textures.clear();
    const { key } = entry;
    const lookUp = (name: string, isData: boolean): Texture | null => {
      if (!this.assets.isReady('texture', name)) {
        this.assets.whenReady('texture', name, () => {
          if (entry.users > 0 && entry.key === key) this.write(entry, values);
        });
        return null;
      }
      const texture = this.assets.texture(name, values.repeat, isData);
      if (!entry.textures.has(texture)) {
        entry.textures.add(texture);
        this.assets.uses.acquire(texture);
      }
      return texture;
    };
    writeMaterial(entry.material, values, lookUp);
    for (const each of before) this.assets.uses.release(each);
  }
}
