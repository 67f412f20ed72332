import type { Command } from '@farol/editing';
import type { AssetLibrary, Scene, SceneView } from '@farol/engine';

/** Sets a value that a function reads and another one writes. */
class SetValue<T> implements Command {
  /** The value before the first `do`, in a list, since it may be null. */
  private before: readonly [T] | null = null;

  constructor(
    readonly label: string,
    private readonly get: () => T,
    private readonly set: (value: T) => void,
    private readonly value: T,
  ) {}

  get isEmpty(): boolean {
    const [before] = this.before ?? [this.get()];
    return before === this.value;
  }

  do(): void {
    this.before ??= [this.get()];
    this.set(this.value);
  }

  undo(): void {
    this.set(this.before![0]);
  }
}

/**
 * Stores a view with a scene, or removes it; `do` throws RangeError for a place or a view that the scene refuses.
 * @param place - number of the view, 1 to 9 @param view - null to remove the view
 */
export const setView = (label: string, { views }: Scene, place: number, view: SceneView | null): Command =>
  new SetValue(
    label,
    () => views.get(place),
    (next) => views.set(place, next),
    view,
  );

/** Adds a folder of assets, or removes an empty one. */
export const setFolder = (label: string, assets: AssetLibrary, path: string, isThere: boolean): Command =>
  new SetValue(
    label,
    () => assets.folders.includes(path),
    (next) => assets.setFolder(path, next),
    isThere,
  );
