import { shortText } from '@farol/editing';
import type { Mesh } from 'three';
import { gameObjectOf } from '../gameObjectOf';
import type { Scene } from '../Scene';

/** Number of updates of the world matrices between two checks. */
const UPDATES = 30;
/** Smallest difference of an element of a world matrix that counts as movement. */
const LEAST = 1e-3;

/** Warns once of a lightmapped mesh that moves while the scene plays, since its baked light does not follow. */
export class MovedObjects {
  /** World matrices of the meshes when their lightmaps were applied; null until recorded. */
  private places: Map<Mesh, readonly number[]> | null = null;
  private updates = 0;
  private isTold = false;
  private readonly stop: () => void;

  constructor(
    private readonly scene: Scene,
    private readonly meshes: ReadonlyMap<Mesh, unknown>,
  ) {
    this.stop = scene.onMatricesUpdated(() => this.update());
  }

  /** Records the matrices anew, as unmoved, after an edit has added, removed or moved lightmapped meshes. */
  changed(): void {
    this.places = null;
  }

  end(): void {
    this.stop();
  }

  private update(): void {
    if (this.isTold) return;
    if (!this.scene.isSimulated) {
      this.changed();
      return;
    }
    if (this.places === null) {
      this.places = new Map([...this.meshes.keys()].map((mesh) => [mesh, [...mesh.matrixWorld.elements]]));
      return;
    }
    this.updates = (this.updates + 1) % UPDATES;
    if (this.updates === 0) this.compare(this.places);
  }

  private compare(places: ReadonlyMap<Mesh, readonly number[]>): void {
    for (const [mesh, place] of places) {
      const { elements } = mesh.matrixWorld;
      for (let i = 0; i < 16; i++) {
        if (Math.abs(elements[i] - place[i]) <= LEAST) continue;
        this.isTold = true;
        const name = shortText(gameObjectOf(mesh)?.name ?? mesh.name);
        console.warn(
          `Farol: '${name}' is static and moves while the scene plays: its baked light does not move with it. Switch Static off and bake again.`,
        );
        return;
      }
    }
  }
}
