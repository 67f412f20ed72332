import { Light, LightGroup, type SceneChange } from '@farol/engine';
import type { Scene as ThreeScene } from 'three';
import type { EditorDocument } from '../model/EditorDocument';

/** Fields of a Light that its icon shows. */
const iconFields = new Set(['diffuse', 'colourBy', 'kelvin']);

/** Whether an edit only changes how lights shine: objects stay where they are, and none comes or goes. */
const isLightAlone = (change: SceneChange): boolean =>
  (change.kind === 'field' || change.kind === 'enabled') &&
  (change.component instanceof LightGroup ||
    (change.component instanceof Light && (change.kind === 'enabled' || change.field !== 'type')));

/**
 * Counts what changes in a document's scene by what a frame must do for it, so that it leaves out what is as it was: a
 * view that turns, or a light that is dimmed, moves none of the scene's objects.
 */
export class SceneStamps {
  /** Grows when objects may have moved, come or gone: with all but the changes that are known to move nothing. */
  places = 0;
  /** Grows when icons may have to look another way, though nothing has moved. */
  icons = 0;
  /** `places` that the world matrices of `current` are of. */
  private updated = -1;
  private current: ThreeScene | null = null;
  private readonly endings: (() => void)[];

  /** @param ask - asks for the next frame, with objects where they are */
  constructor(
    document: EditorDocument,
    private readonly ask: () => void,
  ) {
    const { edited, opened, simulation, sceneChanged, selection, assetsChanged } = document;
    this.endings = [
      sceneChanged.subscribe((change) => {
        if (!isLightAlone(change)) this.places++;
        else if (change.kind !== 'field' || iconFields.has(change.field)) this.icons++;
      }),
      ...[opened, simulation.changed, assetsChanged].map((signal) => signal.subscribe(this.redraw)),
      ...[edited, selection.changed].map((signal) => signal.subscribe(ask)),
    ];
  }

  /** Objects may have moved, by whatever means: the next frame looks at all of them. */
  readonly move = (): void => void this.places++;

  /** Asks for the next frame; objects may have moved. */
  readonly redraw = (): void => {
    this.move();
    this.ask();
  };

  /** Draws a scene, whose world matrices three and Farol bring up to date only when objects may have moved. */
  draw(scene: ThreeScene, draw: () => void): void {
    const { places } = this;
    const { matrixWorldAutoUpdate } = scene;
    if (scene === this.current && places === this.updated) scene.matrixWorldAutoUpdate = false;
    try {
      draw();
      this.current = scene;
      this.updated = places;
    } finally {
      scene.matrixWorldAutoUpdate = matrixWorldAutoUpdate;
    }
  }

  dispose(): void {
    for (const end of this.endings) end();
  }
}
