import type { Command } from '@farol/editing';
import type { Scene } from '@farol/engine';
import type { FieldOwner } from '@farol/engine/fields';
import type { Prefab } from '@farol/engine/prefabs';
import { assetOwners } from '../assetOwners';

/** Renames an asset and its parts, and updates all references to them. */
export class RenameAsset implements Command {
  constructor(
    readonly label: string,
    private readonly scene: Scene,
    private readonly from: string,
    private readonly to: string,
  ) {}

  get isEmpty(): boolean {
    return this.from === this.to;
  }

  do(): void {
    this.rename(this.from, this.to);
  }

  undo(): void {
    this.rename(this.to, this.from);
  }

  /**
   * Renames the asset and updates all references to it. @throws AssetError when the name is taken; nothing has changed
   * then
   */
  private rename(from: string, to: string): void {
    const { scene } = this;
    const names = scene.assets.rename(from, to);
    for (const { owner } of assetOwners(scene)) renameIn(owner, names);
    for (const prefab of scene.prefabs.list) {
      const next = renamedPrefab(scene, prefab, names);
      if (next) scene.prefabs.set(next);
    }
  }
}

function renameIn(owner: FieldOwner, names: ReadonlyMap<string, string>): void {
  for (const [field, { kind, viewOf }] of Object.entries(owner.fields)) {
    const value = kind === 'asset' && viewOf === undefined ? owner.getAuthored(field) : null;
    const next = typeof value === 'string' ? names.get(value) : undefined;
    if (next !== undefined) owner.set(field, next);
  }
}

/** A prefab with renamed assets; null when it refers to none of them. */
function renamedPrefab(scene: Scene, prefab: Prefab, names: ReadonlyMap<string, string>): Prefab | null {
  let isChanged = false;
  const objects = prefab.objects.map((object) => ({
    ...object,
    components: object.components.map((component) => {
      const fields = scene.registry.fieldsOf(component.type);
      const values = { ...component.values };
      for (const [field, value] of Object.entries(values)) {
        const next = fields[field]?.kind === 'asset' && typeof value === 'string' ? names.get(value) : undefined;
        if (next === undefined) continue;
        values[field] = next;
        isChanged = true;
      }
      return { ...component, values };
    }),
  }));
  return isChanged ? { ...prefab, objects } : null;
}
