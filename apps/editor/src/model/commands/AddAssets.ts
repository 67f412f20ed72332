import { type Command, t } from '@farol/editing';
import type { AssetLibrary, TakenAsset } from '@farol/engine';

export class AddAssets implements Command {
  readonly label: string;
  private taken: readonly TakenAsset[];

  constructor(
    private readonly assets: AssetLibrary,
    taken: readonly TakenAsset[],
  ) {
    this.taken = taken;
    this.label =
      taken.length === 1
        ? t('Imported {name}', { name: taken[0].name })
        : t('Imported {count} assets', { count: taken.length });
  }

  get isEmpty(): boolean {
    return this.taken.length === 0;
  }

  get isOfScripts(): boolean {
    return this.taken.every(({ source }) => source.type === 'script' || source.type === 'surface');
  }

  do(): void {
    for (const each of this.taken) this.assets.restore(each);
  }

  undo(): void {
    this.taken = this.taken.map(({ name }) => this.assets.take(name));
  }
}

/** Removes an asset and its parts from the library. Nothing may use it any more. */
export class RemoveAsset implements Command {
  readonly label: string;
  readonly isOfScripts: boolean;
  private taken: TakenAsset | null = null;

  constructor(
    private readonly assets: AssetLibrary,
    private readonly name: string,
  ) {
    this.label = t('Deleted {name}', { name });
    const type = assets.typeOf(name);
    this.isOfScripts = type === 'script' || type === 'surface';
  }

  do(): void {
    this.taken = this.assets.take(this.name);
  }

  undo(): void {
    if (this.taken) this.assets.restore(this.taken);
  }
}
