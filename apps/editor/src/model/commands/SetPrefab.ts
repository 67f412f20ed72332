import { type Command, t } from '@farol/editing';
import type { Scene } from '@farol/engine';
import type { Prefab } from '@farol/engine/prefabs';

/** Adds, replaces (by id) or removes a prefab. Objects of the scene stay as they are. */
export class SetPrefab implements Command {
  readonly label: string;
  private before: Prefab | null = null;
  private order: readonly Prefab[] = [];

  /** @param next - null removes the prefab */
  constructor(
    private readonly scene: Scene,
    private readonly id: string,
    private readonly next: Prefab | null,
  ) {
    this.label = next ? t('Changed prefab') : t('Deleted prefab');
  }

  do(): void {
    const { prefabs } = this.scene;
    this.before = prefabs.get(this.id);
    this.order = prefabs.list;
    if (this.next) prefabs.set(this.next);
    else prefabs.delete(this.id);
  }

  undo(): void {
    const { prefabs } = this.scene;
    if (this.before && this.next) prefabs.set(this.before);
    else if (!this.before) prefabs.delete(this.id);
    else {
      // all prefabs are removed and added again, which restores the order of the list
      for (const { id } of prefabs.list) prefabs.delete(id);
      for (const prefab of this.order) prefabs.set(prefab);
    }
  }
}
