import { Light, LightGroup, type SceneChange } from '@farol/engine';
import type { Scene as ThreeScene } from 'three';
import type { EditorDocument } from '../model/EditorDocument';

/** Fields of a Light that its icon's appearance depends on. */
const iconFields = new Set(['diffuse', 'colourBy', 'kelvin']);

/** Whether an edit changes only the light of objects: none is moved, added or removed. */
const isLightAlone = (change: SceneChange): boolean =>
  (change.kind === 'field' || change.kind === 'enabled') &&
  (change.component instanceof LightGroup ||
    (change.component instanceof Light && (change.kind === 'enabled' || change.field !== 'type')));

/**
 * Counts changes of a document's scene by the work that they cause in a frame, so that unneeded work is left out: an
 * orbiting view, or a dimmed light, moves no object.
 */
export class SceneStamps {
  /** Grows with every change that may move, add or remove an object. */
  places = 0;
  /** Grows when icons may look different though no object has moved. */
  icons = 0;
  /** Value of `places` for which the world matrices of `current` were updated. */
  private updated = -1;
  private current: ThreeScene | null = null;
  private readonly endings: (() => void)[];

  /** Subscribes to the document. @param ask - requests a frame for which no object has moved */
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

  /** Notes that objects may have moved: the next frame updates all of them. */
  readonly move = (): void => void this.places++;

  /** Requests the next frame; objects may have moved. */
  readonly redraw = (): void => {
    this.move();
    this.ask();
  };

  /** Draws a scene; three and Farol update its world matrices only when objects may have moved. */
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
