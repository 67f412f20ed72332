import type { Command } from '@farol/editing';
import type { Scene, SceneView } from '@farol/engine';

/** Stores a view with a scene, or removes it. */
export class SetView implements Command {
  /** View before the first `do`; undefined before that. */
  private before: SceneView | null | undefined;

  /** @param place - number of the view, 1 to 9 @param view - null to remove the view */
  constructor(
    readonly label: string,
    private readonly scene: Scene,
    private readonly place: number,
    private readonly view: SceneView | null,
  ) {}

  get isEmpty(): boolean {
    const before = this.before === undefined ? this.scene.views.get(this.place) : this.before;
    return before === null && this.view === null;
  }

  /** @throws RangeError for a place or a view that the scene refuses */
  do(): void {
    this.before ??= this.scene.views.get(this.place);
    this.scene.views.set(this.place, this.view);
  }

  undo(): void {
    this.scene.views.set(this.place, this.before!);
  }
}
