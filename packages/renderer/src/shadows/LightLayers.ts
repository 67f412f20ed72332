import type { Light, Object3D } from 'three';

type Drawn = Object3D & { isMesh?: boolean; isLine?: boolean; isPoints?: boolean };

/**
 * Finds lights that reach only some of a scene's objects, because light and object must share a layer: collects the objects'
 * sets of layers, and the most frequent set. Ambient and hemisphere lights reach all objects.
 */
export class LightLayers {
  /**
   * Most frequent set of layers among the scene's objects, as bits; 0 when each light of the frame reaches all objects.
   */
  reference = 0;
  private enabled = false;
  /** Sets of layers that the scene's objects have, as bits; `counts` tells how many objects have each. */
  private readonly sets: number[] = [];
  private readonly counts: number[] = [];
  /** Whether some light of the frame does not reach all objects. */
  private hasLimited = false;

  /** Begins a frame. @param enabled - whether lights reach only objects that share a layer with them */
  begin(root: Object3D, enabled: boolean): void {
    this.enabled = enabled;
    this.sets.length = this.counts.length = 0;
    this.hasLimited = false;
    this.reference = 0;
    if (enabled && root.visible) this.visit(root);
  }

  /** True for a light that does not reach all objects. */
  separates(light: Light): boolean {
    if (!this.enabled) return false;
    for (const layers of this.sets) {
      if ((layers & light.layers.mask) !== 0) continue;
      this.hasLimited = true;
      return true;
    }
    return false;
  }

  /** Sets `reference` to the most frequent set of layers. Call after `separates` was called for all lights. */
  end(): void {
    if (!this.hasLimited) return;
    let most = 0;
    for (let i = 0; i < this.sets.length; i++) {
      if (this.counts[i] <= most) continue;
      most = this.counts[i];
      this.reference = this.sets[i];
    }
  }

  private visit(object: Object3D): void {
    const drawn = object as Drawn;
    if (drawn.isMesh || drawn.isLine || drawn.isPoints) {
      const { mask } = object.layers;
      const i = this.sets.indexOf(mask);
      if (i >= 0) this.counts[i]++;
      else {
        this.sets.push(mask);
        this.counts.push(1);
      }
    }
    const { children } = object;
    for (let i = 0; i < children.length; i++) if (children[i].visible) this.visit(children[i]);
  }
}
